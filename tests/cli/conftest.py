"""Fixtures that run commands."""

import pytest

from rimroll.cli import main


@pytest.fixture
def stdout_of(capsys):
    """Runs a command that must exit with a code, and returns its stdout with single spaces."""

    def run(arguments, code=0):
        assert main(arguments.split()) == code
        return " ".join(capsys.readouterr().out.split())

    return run


@pytest.fixture
def error_of(capsys):
    """Runs a command that must fail, and returns its stderr."""

    def run(arguments):
        assert main(arguments.split()) == 2
        return capsys.readouterr().err

    return run
