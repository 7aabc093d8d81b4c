"""Studies: computations over many bodies, frictions, starts and records.

A :class:`rimroll.Study` says what varies, and ``study.plan()`` what that amounts to: rows, labelled
dimensions, and the columns of any chunk of rows, which are a pure function of the study and the
numbers of the rows. So chunks can be computed in any order, by any process, on any machine.

``study`` is the public class, ``description`` reads its tables, ``axes`` and ``draws`` say what
varies. ``setups`` makes bodies, starts, laws and grounds of some rows, ``kinds`` computes their
columns, ``statistics`` reduces them, and ``plan`` has the whole. ``store`` and ``chunks`` are on
the disk, ``run``, ``work`` and ``cluster`` fill them, ``status`` and ``figures`` show them.
"""
