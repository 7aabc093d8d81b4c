"""Gyroscopes: ``rimroll.gyro`` has the public names.

A record (``record``, ``files``; simulated: ``sensor``) shows falls (``peaks``), whose turns
(``passages``, ``collision``) imply a friction (``friction``); ``reading`` reads a record and
``analysis`` is what it says. ``motion_fit`` fits whole motions.
"""
