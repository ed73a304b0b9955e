"""Classes of the results of all commands: DiagnoseResult, PlanResult, ..."""
from .commands import COMMANDS, result_class

globals().update({made.__name__: made for made in map(result_class, COMMANDS)})
