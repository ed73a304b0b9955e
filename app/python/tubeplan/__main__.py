"""The program by `python3 -m tubeplan COMMAND ...`."""
import sys

from . import _core


def main() -> int:
    return _core.call_for_terminal(sys.argv[1:])


if __name__ == '__main__':
    sys.exit(main())
