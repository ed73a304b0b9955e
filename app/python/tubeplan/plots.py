"""Pictures of results by matplotlib, which is imported where one is drawn. PLOTS has a row for each kind."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .result import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]
_MOST_GROUPS = 12
_FEW_VALUES = 5


def plot(result: Result, ax: Axes | None = None) -> Figure:
    """Draws a result into `ax`, or into a figure of its own, and returns the figure."""
    if result.command not in PLOTS:
        raise TypeError(f'a result of {result.command} has no picture; results of {", ".join(sorted(PLOTS))} have one')
    if ax is None:
        from matplotlib import pyplot
        _, ax = pyplot.subplots(figsize=(8, 4.5), constrained_layout=True)
    PLOTS[result.command](result, ax)
    figure: Figure = ax.figure
    return figure


def ladder(result: Result, ax: Axes) -> None:
    """Draws fitted and held-out error of every model, and the noise floor."""
    errors = [model['rms'] for model in result['models']]
    rows = np.arange(len(errors))
    ax.barh(rows - 0.2, [_known(error['fitted']) for error in errors], 0.38, label='fitted')
    ax.barh(rows + 0.2, [_known(error['heldout']) for error in errors], 0.38, label='held out')
    ax.axvline(_known(errors[-1]['noise_floor']), color='k', linestyle=':', label='noise floor')
    ax.set_yticks(rows, [model['name'].rsplit('/', 1)[-1] for model in result['models']])
    ax.invert_yaxis()
    ax.set_xlabel(f'error [{result["error_unit"]}]')
    ax.legend()


def parameters(result: Result, ax: Axes) -> None:
    """Draws the interval of every identified number about its initial value, in standard deviations."""
    for k, number in enumerate(result['parameters']):
        sigma = _known(number['sigma'])
        ax.errorbar((_known(number['value']) - _known(number['start'])) / sigma, k, xerr=2, fmt='o', capsize=3, color='C0')
    ax.axvline(0, color='k', linestyle=':')
    ax.set_yticks(range(len(result['parameters'])), [number['name'] for number in result['parameters']])
    ax.invert_yaxis()
    ax.set_xlabel('found less initial, in standard deviations')


def error_map(result: Result, ax: Axes) -> None:
    """Draws the error of every reading as an arrow where it was read: on the sheet, or seen from above."""
    readings = [one for one in result['readings'] if one['position_before'] and one['error_before'] and len(one['error_before']) == 3]
    if not readings:
        raise TypeError('no reading has a place and an error along x, y and z')
    places = np.array([one['position_before'] for one in readings])
    for key, color in (('error_before', 'C3'), ('error_after', 'C0')):
        errors = np.array([one[key] or [np.nan] * 3 for one in readings], float)
        ax.quiver(places[:, 0], places[:, 1], errors[:, 0], errors[:, 1], color=color, angles='xy', width=0.003,
                  label=key.replace('_', ' '))
    length = result['units']['length']
    ax.set(xlabel=f'x [{length}]', ylabel=f'y [{length}]', aspect='equal')
    ax.legend()


def law(result: Result, ax: Axes) -> None:
    """Draws the error and its explained part against the variable of the law that the error follows most closely."""
    readings = [one for one in result['readings'] if one['before']]
    if not readings:
        raise TypeError('the diagnosis has no error of a reading')
    has_cause = bool(result['explanations']) and all(one['explained'] and one['explained'][0] for one in readings)
    shown = np.array([one['explained'][0] if has_cause else one['before'] for one in readings])
    causes = result['explanations'][0]['effects'] if has_cause else ()
    sizes = (shown ** 2).mean(axis=0)
    _, part, name, column = max(((sizes[part] * _followed(column, shown[:, part]), part, name, column)
                                 for name, column in _variables(result, readings, causes) for part in range(shown.shape[1])),
                                key=lambda view: float(view[0]))
    ax.plot(column, [one['before'][part] for one in readings], '.', color='0.6', label='error before')
    if has_cause:
        ax.plot(column, shown[:, part], '+', color='C3', label=result['explanations'][0]['found'])
    ax.axhline(0, color='k', linewidth=0.5)
    ax.set(xlabel=name, ylabel=f'error along {"xyz"[part] if shown.shape[1] == 3 else part} [{result["error_unit"]}]',
           title=result['verdict_words'] or result['verdict'])
    ax.legend()


def tour(result: Result, ax: Axes) -> None:
    """Draws the visited holes in their order, coloured by the steps of the tool that enter."""
    tubes = result['tubes']
    if not tubes:
        raise TypeError('the plan visits no tube')
    holes = np.array([tube['hole'] for tube in tubes])
    ax.plot(holes[:, 0], holes[:, 1], '-', color='0.7', linewidth=1, zorder=1)
    steps = np.array([-1 if tube['steps'] is None else tube['steps'] for tube in tubes])
    for count in np.unique(steps):
        ax.plot(*holes[steps == count, :2].T, 'o', label='not known' if count < 0 else f'{count} steps')
    length = result['units']['length']
    ax.set(xlabel=f'x [{length}]', ylabel=f'y [{length}]', aspect='equal')
    ax.legend()


def _known(value: float | None) -> float:
    return float('nan') if value is None else value


def _variables(result: Result, readings: list[Any], causes: Any) -> list[tuple[str, Array]]:
    """Returns what differs between the readings: the variables of the causes' laws, else all that is stated."""
    units = result['units']
    stated = [('joint', joint['name'], f'{joint["name"]} [{joint["unit"]}]', [one['joints'][k] for one in readings])
              for k, joint in enumerate(result['joints'])]
    stated += [('sense', joint['name'], f'sense of {joint["name"]}', [one['senses'][k] for one in readings])
               for k, joint in enumerate(result['joints']) if all(one.get('senses') for one in readings)]
    stated.append(('load', '', f'load [{units["force"]}]', [one['load'] for one in readings]))
    stated += [(kind['name'], '', f'{kind["name"]} [{kind["unit"]}]', [one.get(kind['name']) for one in readings])
               for kind in units['conditions']]
    joints = {joint['name'] for joint in result['joints']}
    own = {(kind, place) for cause in causes for kind in cause['varies_with'] for place in cause['at'].split('<-')[-1:]}
    varied = [(kind, at, name, np.array(column, float)) for kind, at, name, column in stated]
    varied = [one for one in varied if len(np.unique(one[3][np.isfinite(one[3])])) > 1]
    of_law = [one for one in varied if any(one[0] == kind and (one[1] == place or not one[1] or place not in joints) for kind, place in own)]
    return [(name, column) for _, _, name, column in of_law or varied] or [('reading', np.arange(len(readings), dtype=float))]


def _followed(column: Array, values: Array) -> float:
    """Returns the share of the values' variance that lies between groups of readings alike in this variable."""
    kept = np.isfinite(column)
    column, values = column[kept], values[kept]
    distinct = np.unique(column)
    cuts = distinct[1:] if len(distinct) <= _FEW_VALUES else np.quantile(column, np.linspace(0, 1, _MOST_GROUPS + 1)[1:-1])
    groups = np.searchsorted(cuts, column, side='right')
    within = sum(float(((values[groups == k] - values[groups == k].mean()) ** 2).sum()) for k in np.unique(groups))
    return 1 - within / (float(((values - values.mean()) ** 2).sum()) or 1)


PLOTS: dict[str, Callable[[Result, Any], None]] = {
    'ladder': ladder, 'improve': ladder, 'identify': parameters, 'compare': error_map, 'diagnose': law, 'plan': tour}
