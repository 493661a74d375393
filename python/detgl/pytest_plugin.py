"""The fixture `golden`, and `pytest --bless`; pytest finds this by itself."""

import shutil

import pytest

_FAILURES = "golden-failures"


def pytest_addoption(parser):
    group = parser.getgroup("detgl")
    group.addoption("--bless", action="store_true", help="write the pictures that `golden` compares with")


def pytest_sessionstart(session):
    # The page is of this run alone. Other processes of pytest-xdist find it done.
    if not hasattr(session.config, "workerinput"):
        shutil.rmtree(session.config.rootpath / _FAILURES, ignore_errors=True)


@pytest.fixture
def golden(request):
    """golden.check(picture, "name") compares with golden/name.png beside the test; golden.digest(picture) is a number
    to compare in place of a picture."""
    from .golden import Golden, digest

    bless = request.config.getoption("--bless")
    checker = Golden(request.path.parent / "golden", request.config.rootpath / _FAILURES, bless)
    checker.digest = digest
    return checker
