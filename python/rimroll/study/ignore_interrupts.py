"""Makes local workers ignore Ctrl-C, which a terminal sends them too; the client ends them."""

import signal
import threading

if threading.current_thread() is threading.main_thread():
    signal.signal(signal.SIGINT, signal.SIG_IGN)
