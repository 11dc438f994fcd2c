"""Ctrl-C in a Python program."""
import signal
import subprocess
import sys
import time


def seconds_until_stopped(setup, loop, wait):
    """Runs `setup`, then `loop`, sends SIGINT `wait` seconds later; returns the seconds until KeyboardInterrupt [s].

    Raises AssertionError if the loop does not end with KeyboardInterrupt.
    """
    code = (setup + "\nprint('ready', flush=True)\ntry:\n    " + loop +
            "\nexcept KeyboardInterrupt:\n    print('stopped', flush=True)\n")
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    child.stdout.readline()
    time.sleep(wait)
    begin = time.monotonic()
    child.send_signal(signal.SIGINT)
    answer = child.stdout.readline()
    seconds = time.monotonic() - begin
    child.communicate(timeout=60)
    assert answer == "stopped\n", answer
    return seconds
