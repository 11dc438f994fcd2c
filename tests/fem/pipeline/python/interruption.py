"""Ctrl-C in a Python program."""
import signal
import subprocess
import sys
import time


def is_stopped(setup, loop, wait):
    """Runs `setup`, then `loop`, and sends SIGINT `wait` seconds later; True if the loop ends with KeyboardInterrupt."""
    code = (setup + "\nprint('ready', flush=True)\ntry:\n    " + loop +
            "\nexcept KeyboardInterrupt:\n    print('stopped', flush=True)\n")
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    child.stdout.readline()
    time.sleep(wait)
    child.send_signal(signal.SIGINT)
    return child.communicate()[0] == "stopped\n"
