"""The one error of this package."""


class RipstikError(Exception):
    """What a person can mend, in one line: a scenario or study that is refused, a start that does not exist, no Node."""
