// The errors plotted against any variable of the readings, with hollow marks before and filled marks after on a common
// scale, with the law of the cause as a line and bin means with error bars.
import {useMemo, useRef} from "preact/hooks";
import {palette} from "../drawing/colours";
import {explanationTitle} from "../../../drawing/explanations.js";
import {Select} from "../drawing/fields";
import {Plot} from "../drawing/plot";
import {choicesOf} from "../drawing/segments";
import type {View} from "../../../drawing/own_variable.js";
import {commonMost, letterOf} from "../../../drawing/reading_errors.js";
import {MOST_MARKS} from "../../../drawing/shares.js";
import {makePlot} from "./error_plot";
import {chosenPart, chosenVariable, parts, secondView, shownView, variables} from "./focus";
import {currentDiagnosis} from "./loop";
import {SeriesLegend} from "./series_legend";
import {PointedReading, usePointing} from "./pointing";
import {
  chooseSecond,
  drawnExplanation,
  readingErrors,
  type ReadingErrors,
  secondErrors,
  secondExplanation,
} from "./residuals";

const choiceOf = ({key, name}: {key: string; name: string}) => ({value: key, words: name});

export function ResidualPlot() {
  const errors = readingErrors.value,
    view = shownView.value,
    second = secondErrors.value,
    other = secondView.value;
  const most = errors && view && second && other ? commonMost([errors, view], [second, other]) : null;
  return (
    <section class="panel residual-plot">
      <header>
        <h2>Error against</h2>
        <Select
          label="Variable"
          choices={variables.value.map(choiceOf)}
          value={view?.variable.key ?? ""}
          onChoose={(key) => (chosenVariable.value = key)}
        />
        <div class="end">
          <SecondChoice />
          <Select
            label="Part of the error"
            choices={parts.value.map(choiceOf)}
            value={view?.part.key ?? ""}
            onChoose={(key) => (chosenPart.value = key)}
          />
        </div>
      </header>
      <div class={`plots ${second ? "two" : ""}`}>
        <ErrorPlot errors={errors} view={view} most={most} index={second ? drawnExplanation.value : -1} />
        {second && other ? (
          <ErrorPlot errors={second} view={other} most={most} index={secondExplanation.value} />
        ) : null}
      </div>
    </section>
  );
}

/** Choice of a second explanation next to the drawn one; empty if there is only one explanation. */
function SecondChoice() {
  const explanations = currentDiagnosis.value?.explanations ?? [];
  if (explanations.length < 2) return null;
  const drawn = drawnExplanation.value;
  const others = explanations.flatMap((_, index): [number, string][] =>
    index === drawn ? [] : [[index, `${letterOf(drawn)} beside ${letterOf(index)}`]],
  );
  return (
    <Select
      label="Explanation beside"
      choices={choicesOf([[-1, `${letterOf(drawn)} alone`], ...others])}
      value={secondExplanation.value}
      onChoose={chooseSecond}
    />
  );
}

interface ErrorPlotProps {
  errors: ReadingErrors | null;
  view: View | null;
  /** Upper end of the error scale that this plot shares with the plot next to it; null for a separate scale. */
  most: number | null;
  /** Index of the explanation in this plot if two explanations are side by side; -1 for a single plot. */
  index: number;
}

function ErrorPlot({errors, view, most, index}: ErrorPlotProps) {
  const plot = useMemo(
    () => (errors && view ? makePlot(errors, view, {colours: palette.peek(), most, isBrief: index >= 0}) : null),
    [errors, view, palette.value, most, index],
  );
  const box = useRef<HTMLDivElement>(null);
  const pointing = usePointing(box, plot?.rows ?? null);
  const title = index >= 0 ? explanationTitle({effects: errors?.causes ?? []}) : "";
  return (
    <div class="panel-body flush with-legend" ref={box}>
      {index >= 0 ? (
        <p class="plot-title" title={title}>
          <b>{letterOf(index)}</b> {title}
        </p>
      ) : null}
      {plot ? (
        <Plot options={plot.options} data={plot.data} label={plot.words} onReady={pointing.onReady} />
      ) : (
        <p class="muted pad">Readings appear here after a comparison.</p>
      )}
      <PointedReading place={pointing.place} errors={errors} />
      <PlotLegend errors={errors} hasLaw={(plot?.law.length ?? 0) > 0} isBrief={index >= 0} />
    </div>
  );
}

function PlotLegend({errors, hasLaw, isBrief}: {errors: ReadingErrors | null; hasLaw: boolean; isBrief: boolean}) {
  return (
    <SeriesLegend errors={errors} isBrief={isBrief} most={MOST_MARKS}>
      <span>
        <i class="means-sign" /> means {isBrief ? "" : errors?.judged === 1 ? "after " : "before "}± 2 s.e.
      </span>
      {hasLaw ? (
        <span title="Part of the error that the chosen cause explains, as a mean along the variable; the band is its spread">
          <i class="law-sign" /> law
        </span>
      ) : null}
    </SeriesLegend>
  );
}
