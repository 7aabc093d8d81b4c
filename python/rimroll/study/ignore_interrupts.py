"""Loaded by local workers: Ctrl-C in a terminal reaches them, too, but the client ends them."""

import signal
import threading

if threading.current_thread() is threading.main_thread():
    signal.signal(signal.SIGINT, signal.SIG_IGN)
