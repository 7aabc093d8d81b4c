"""``rimroll lab`` serves the page that comes with the package, to this machine alone."""

import gzip
import math
import re
import socket
import struct
from http.client import HTTPConnection
from threading import Thread
from urllib.parse import unquote

import pytest

from given.ctrl_c import interrupt, needs_signals, running
from rimroll.browser import setup
from rimroll.browser.page import PageServer
from rimroll.cli import main

FILES = {
    "index.html": (b"<!doctype html><title>a page</title>", "text/html; charset=utf-8"),
    "assets/page.js": (b"console.log(1)", "text/javascript"),
    "assets/page.css": (b":root { color: red }", "text/css"),
    "assets/core.wasm": (b"\0asm\1\0\0\0" + bytes(range(256)), "application/wasm"),
    "setup.json": (
        b'{"body": {"choices": ["can_2007", "coin"]},'
        b' "tilt": {"unit": "\xc2\xb0", "min": 0, "max": 90, "open": true, "whole": false},'
        b' "record": {"pattern": "([a-z]{2})*"},'
        b' "flicks": {"unit": "", "min": 1, "max": 1000, "open": false, "whole": true}}',
        "application/json",
    ),
    "licences.txt": ("François".encode(), "text/plain; charset=utf-8"),
}


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package with a page of a few files, and a private file beside it."""
    for name, (content, _) in FILES.items():
        file = tmp_path / "page" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    (tmp_path / "secret.txt").write_text("secret")
    monkeypatch.setattr("rimroll.browser.page.resources.files", lambda _name: tmp_path)
    return tmp_path


@pytest.fixture
def server(package):
    with PageServer(package / "page") as server:
        thread = Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        yield server
        server.shutdown()
        thread.join()


def get(server, path, **headers):
    """Requests a path unchanged; a client that normalises paths would hide errors."""
    connection = HTTPConnection("127.0.0.1", server.server_port)
    connection.request("GET", path, headers=headers)
    response = connection.getresponse()
    content = response.read()
    connection.close()
    return response, content


@pytest.mark.parametrize("name", FILES)
def test_what_is_served_is_the_file_and_says_what_it_is(server, name):
    response, content = get(server, "/" + name)
    assert response.status == 200
    assert (content, response.headers["Content-Type"]) == FILES[name]


def test_the_address_is_that_of_the_page(server):
    assert server.address == f"http://127.0.0.1:{server.server_port}/"
    assert get(server, "/")[1] == FILES["index.html"][0]


@pytest.mark.parametrize(
    "path",
    ["/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt", "//../secret.txt"],
)
def test_nothing_beside_the_page_is_served(server, path):
    response, content = get(server, path)
    assert response.status == 404
    assert content != b"secret"


@pytest.mark.parametrize("path", ["/%00", "/index.html%00", "/" + "a" * 5000, "/?q=%ff", "/%ff"])
def test_odd_paths_are_not_found_and_print_nothing(server, capfd, path):
    assert get(server, path)[0].status == (200 if path.startswith("/?") else 404)
    assert capfd.readouterr() == ("", "")


def test_a_browser_that_ends_a_request_early_prints_nothing(server, capfd):
    for request in (
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1",
        b"GET / HTTP/1.1\r\n\r\n",
        b"\x00\xff\r\n\r\n",
    ):
        with socket.create_connection(server.server_address) as connection:
            # A reset in the middle of the answer.
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            connection.sendall(request)
    assert get(server, "/")[0].status == 200
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("host", ["rebound.example", "rebound.example:{port}", "127.0.0.1.example"])
def test_another_host_name_is_not_answered(server, host):
    response, content = get(server, "/", Host=host.format(port=server.server_port))
    assert response.status == 421
    assert FILES["index.html"][0] not in content


@pytest.mark.parametrize("host", ["127.0.0.1:{port}", "localhost:{port}", "localhost"])
def test_its_own_host_name_is_answered(server, host):
    assert get(server, "/", Host=host.format(port=server.server_port))[0].status == 200


def test_what_is_served_keeps_to_itself(server):
    for path in ("/", "/assets/page.js", "/missing"):
        headers = get(server, path)[0].headers
        assert headers["X-Content-Type-Options"] == "nosniff"
        policy = headers["Content-Security-Policy"]
        assert policy.startswith("default-src 'none'; script-src 'self'")
        assert "'wasm-unsafe-eval'" in policy
        assert not re.search(r"https?:|\*", policy)


@pytest.mark.parametrize("name", FILES)
def test_files_are_compressed_for_those_who_ask(server, name):
    response, content = get(server, "/" + name, **{"Accept-Encoding": "gzip, br"})
    assert response.headers["Content-Encoding"] == "gzip"
    assert gzip.decompress(content) == FILES[name][0]
    assert "Content-Encoding" not in get(server, "/" + name)[0].headers


def test_folders_are_not_listed(server):
    response, content = get(server, "/assets/")
    assert response.status == 404
    assert b"page.js" not in content


def test_only_this_machine_is_served(server):
    assert server.server_address[0] == "127.0.0.1"


def test_two_labs_take_two_ports(package):
    with PageServer(package / "page") as one, PageServer(package / "page") as other:
        assert one.server_port != other.server_port


def test_a_port_that_is_taken_is_refused_by_its_number(server, capsys):
    assert main(["lab", "--no-browser", "--port", str(server.server_port)]) == 2
    assert f"--port {server.server_port} cannot be served on" in capsys.readouterr().err


def test_without_the_built_page_it_says_how_to_build_it(package, capsys):
    (package / "page" / "index.html").unlink()
    assert main(["lab", "--no-browser"]) == 2
    assert "make web" in capsys.readouterr().err


def opened(monkeypatch, *arguments):
    """The address that the browser opens; the lab ends at once."""
    addresses = []

    def browser(address):
        addresses.append(address)
        raise KeyboardInterrupt

    monkeypatch.setattr("rimroll.cli.lab.webbrowser.open", browser)
    assert main(["lab", *arguments]) == 0
    return addresses[0]


def test_the_browser_is_opened_at_the_page(package, monkeypatch, capsys):
    address = opened(monkeypatch)
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/#lab", address)
    assert f"The lab is at {address}" in capsys.readouterr().out


def test_the_browser_is_opened_with_the_set_up(package, monkeypatch):
    assert opened(monkeypatch, "--setup", "body=coin&tilt=60").endswith("/#body=coin&tilt=60")


@pytest.mark.parametrize(
    ("setup", "reason"),
    [
        ("body=nonsense", "body cannot be 'nonsense': choose from can_2007, coin"),
        ("body=coins", "body cannot be 'coins': did you mean 'coin'?"),
        ("tllt=20", "there is no quantity 'tllt': did you mean 'tilt'?"),
        ("nonsense", "there is no quantity 'nonsense'"),
        ("tilt=steep", "tilt must be a number, got 'steep'"),
        ("tilt=", "tilt must be a number, got ''"),
        ("tilt=nan", "tilt must be a number, got 'nan'"),
        ("tilt=Infinity", "tilt must be between 0 and 90 (°), got 'Infinity'"),
        ("flicks=1,000", "flicks must be a number, got '1,000'"),
        ("body=coin&tilt=90", "tilt must be between 0 and 90 (°), got '90'"),
        ("record=abc", "record is not one that the page has written"),
        ("flicks=1001", "flicks must be from 1 to 1000, got '1001'"),
        ("flicks=2.5", "flicks must be a whole number, got '2.5'"),
    ],
)
def test_a_set_up_that_the_page_does_not_take_is_refused_at_once(package, capsys, setup, reason):
    assert main(["lab", "--no-browser", "--setup", setup]) == 2
    assert f"--setup: {reason}" in capsys.readouterr().err


def test_a_page_too_old_to_check_a_set_up_by_is_to_be_built_again(package, capsys):
    (package / "page" / "setup.json").unlink()
    assert main(["lab", "--no-browser", "--setup", "tilt=20"]) == 2
    assert "make web" in capsys.readouterr().err


@pytest.mark.parametrize(
    "setup", ["tilt=12,5", "tilt=20°", "flicks=3", "body=coin&tilt=60", "record=abcd", "record="]
)
def test_a_set_up_that_the_page_takes_is_opened(package, monkeypatch, setup):
    assert unquote(opened(monkeypatch, "--setup", setup)).endswith(f"/#{setup}")


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("12", 12.0),
        (" 12 ° ", 12.0),
        ("12,5", 12.5),
        ("0,125", 0.125),
        ("1,0000", 1.0),
        ("\N{MINUS SIGN}3e\N{MINUS SIGN}2", -0.03),
        ("+.5", 0.5),
        ("5.", 5.0),
        ("0x1F", 31.0),
        ("0x" + "F" * 300, math.inf),
        ("-Infinity", -math.inf),
        ("1,000", None),
        ("\N{MINUS SIGN}1,000,000°", None),
        ("1,5,5", None),
        ("1_0", None),
        ("-0x1F", None),
        ("\N{ARABIC-INDIC DIGIT THREE}", None),
        ("inf", None),
        ("nan", None),
        ("1 2", None),
        ("", None),
        ("°", None),
    ],
)
def test_a_number_of_a_set_up_is_read_as_the_page_reads_it(text, number):
    assert setup._number(text, "°") == number


@needs_signals
def test_ctrl_c_ends_it_in_peace(package):
    code = (
        "import pathlib, sys; from importlib import resources;"
        f"resources.files = lambda _: pathlib.Path({str(package)!r});"
        "from rimroll.cli import main; sys.exit(main(['lab', '--no-browser']))"
    )
    with running("-c", code, env={"PYTHONUNBUFFERED": "1"}) as lab:
        assert "http://127.0.0.1:" in lab.stdout.readline()
        assert "Ctrl-C" in lab.stdout.readline()
        _, errors = interrupt(lab)
    assert (lab.returncode, errors) == (0, "")
