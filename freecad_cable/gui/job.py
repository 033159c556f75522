# SPDX-License-Identifier: LGPL-2.1-or-later
"""One solve beside the window."""

import threading
import time

import FreeCAD

from ..document.sentences import in_language
from ..errors import StoppedError
from ..shape.units import sentence_from_si

translate = FreeCAD.Qt.translate


class Job:
    """One solve; ``work(watch)`` does it. The answer of a preview goes to ``receive(value, error)``, that of another to
    its cable."""

    def __init__(self, key, inputs, work, receive=None):
        self.key, self.inputs, self.work, self.receive = key, inputs, work, receive
        self.begun = time.monotonic()
        self.said = ""
        """what the solver is about to do"""
        self.dropped = self.stopped = False
        """nobody wants the answer; a person does not want to wait for it"""
        self.taken = False
        """the receiver has it"""
        self.value = self.error = None
        self.done = threading.Event()

    def watch(self, sentence):
        self.said = sentence
        if self.dropped or self.stopped:
            raise StoppedError("The solve was stopped.")

    def run(self, watch):
        try:
            if not (self.dropped or self.stopped):
                self.value = self.work(watch)
        except Exception as error:  # noqa: BLE001 - raised again in the main thread
            self.error = error
        self.done.set()

    @property
    def succeeded(self):
        return self.error is None and self.value.status.success

    def answer(self):
        if self.error is not None:
            raise self.error.with_traceback(None)
        return self.value


def in_words(job) -> str:
    """How far it is, in the words of a person."""
    seconds = f"{time.monotonic() - job.begun:.0f} s"
    if not job.said:
        return translate("Cable", "Waiting to be solved: {seconds}").format(seconds=seconds)
    said = translate("Cable", "Solving: {seconds}, {what}")
    return said.format(seconds=seconds, what=in_language(sentence_from_si(job.said)))
