# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls that may never return, in a process of their own that is ended when they do not."""

import multiprocessing


class Guarded:
    """A function of a module, called in another process; that process lives on from call to call, so that
    solvers built in it are used again. A context manager."""

    def __init__(self, function, patience, rehearsal):
        """``patience``: [s] for one call. ``rehearsal``: arguments of a call that a new process makes
        first, however long it takes, so that no other call has to wait for imports."""
        self.function, self.patience, self.rehearsal = function, patience, rehearsal
        self.process = None

    def __call__(self, *arguments):
        """What the function returns or raises. Errors: ``TimeoutError`` if it does not return in time,
        ``ChildProcessError`` if its process crashes."""
        self.ready()
        return self._answer(arguments, self.patience)

    def ready(self):
        """Have a process that is rehearsed; who takes the time of a call does this before."""
        if self.process is None:
            self._start()
            self._answer(self.rehearsal, None)

    def _answer(self, arguments, patience):
        self.pipe.send(arguments)
        if not self.pipe.poll(patience):
            self._end()
            raise TimeoutError(
                f"It did not return within {patience:g} s, and its process was ended."
            )
        try:
            answer = self.pipe.recv()
        except EOFError:
            self._end()
            raise ChildProcessError("Its process crashed.") from None
        if isinstance(answer, Exception):
            raise answer
        return answer

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process is not None:
            self._end()

    def _start(self):
        # Not a copy of this process: the solver's library may not survive being copied.
        context = multiprocessing.get_context("spawn")
        self.pipe, far = context.Pipe()
        self.process = context.Process(target=_serve, args=(self.function, far), daemon=True)
        self.process.start()
        far.close()

    def _end(self):
        self.process.kill()
        self.process.join()
        self.pipe.close()
        self.process = None


def _serve(function, pipe):
    while True:
        try:
            answer = function(*pipe.recv())
        except Exception as error:  # noqa: BLE001  It is raised again on the other side.
            answer = error
        pipe.send(answer)
