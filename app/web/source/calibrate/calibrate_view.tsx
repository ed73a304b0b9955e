// The calibrate view: three holes to touch, the best of them ringed; joints entered or simulated; where the base stands,
// what is left at each touch, how sure that is, and what it does to the error over the sheet.
import {effect, signal} from "@preact/signals";
import {useCallback, useMemo} from "preact/hooks";
import {MarkIcon} from "../drawing/marks";
import {Icon} from "../drawing/icons";
import {fixed, short} from "../drawing/numbers";
import type {CalibrateDocument, FieldDocument, TouchesDocument, TouchList} from "../server/documents";
import {get, remove} from "../server/requests";
import {cell, order, report, result, runJob, runningJob, state, units} from "../server/workbench";
import {picked, sheet, view} from "../shell/page_state";
import {Nothing, ProblemWords, Waiting} from "../shell/states";
import {byField, byState} from "../sheet/colourings";
import {toPixel} from "../sheet/sheet_camera";
import {holeName, type SheetModel} from "../sheet/sheet_model";
import {SheetPicture, type PaintOver} from "../sheet/sheet_picture";
import {Covariance} from "./covariance";

const proposals = result<TouchesDocument>("touches"),
  outcome = result<CalibrateDocument>("calibrate"),
  field = result<FieldDocument>("field");
const touches = signal<TouchList["touches"]>([]);
const isHeat = signal(true);

effect(() => {
  void state.value?.revision;
  if (state.value === null || view.value !== "calibrate") return;
  get<TouchList>("/api/touches").then(
    (list) => (touches.value = list.touches ?? []),
    () => (touches.value = []),
  );
});

function holeOf(model: SheetModel, point: string): number {
  const found = /R(\d+)\s*C(\d+)/.exec(point);
  return found ? model.find(Number(found[1]), Number(found[2])) : -1;
}

export function CalibrateView() {
  if (cell.value && !cell.value.has_sheet) {
    return (
      <Nothing title={`${cell.value.name} has no tube sheet`}>
        <p>A base is found by touching holes. Open a cell with a sheet.</p>
      </Nothing>
    );
  }
  const model = sheet.value;
  if (!model) return <Waiting words="Reading the sheet" isBusy />;
  return (
    <div class="calibrate-view">
      <TouchSheet model={model} />
      <aside class="side">
        <TouchPanel model={model} />
        <BasePanel />
      </aside>
    </div>
  );
}

function TouchSheet({model}: {model: SheetModel}) {
  const found = field.value.document;
  const isField = isHeat.value && found?.of === "centring" && found.values.length === model.count;
  const colouring = useMemo(
    () => (isField ? byField(model, found!, "Predicted error") : byState(model)),
    [model, isField, found],
  );
  const suggested = useMemo(
    () => (proposals.value.document?.next_readings ?? []).map((reading) => holeOf(model, reading.point)),
    [model, proposals.value.document],
  );
  const paintOver = useCallback<PaintOver>(
    (context, camera, size, colours) => {
      const ring = (hole: number, colour: string, words: string, dash: number[]) => {
        if (hole < 0) return;
        const [x, y] = toPixel(camera, size, model.u[hole], model.v[hole]);
        context.beginPath();
        context.arc(x, y, 12, 0, 2 * Math.PI);
        context.setLineDash(dash);
        context.strokeStyle = colour;
        context.lineWidth = 3;
        context.stroke();
        context.setLineDash([]);
        label(context, words, x, y, size.width, colours.ink, colours.panel);
      };
      const done = touches.peek().map((touch) => touch.hole);
      suggested.forEach((hole, i) => {
        if (!done.includes(hole)) ring(hole, colours.accent, `best ${i + 1}: ${holeName(model, hole)}`, [5, 4]);
      });
      done.forEach((hole, i) => ring(hole, colours.good, `T${i + 1}: ${holeName(model, hole)}`, []));
    },
    [model, suggested, touches.value],
  );
  return (
    <section class="panel">
      <header>
        <h2>Touches</h2>
        <div class="end">
          <label class="check">
            <input type="checkbox" checked={isHeat.value} onChange={() => (isHeat.value = !isHeat.value)} /> predicted
            error
          </label>
          <button
            class="button"
            disabled={runningJob("field") !== null}
            onClick={() => {
              isHeat.value = true;
              void runJob("Predicted error", "/api/field", {of: "centring"});
            }}
          >
            Predict
          </button>
        </div>
      </header>
      <div class="panel-body flush">
        <SheetPicture
          sheet={model}
          colouring={colouring}
          picked={picked}
          paintOver={paintOver}
          onPick={(hole) => (picked.value = hole)}
        />
      </div>
      <footer class="stage-foot">
        {isField ? (
          colouring.kinds.map((kind) => (
            <span title={colouring.meaning}>
              <MarkIcon mark={kind.mark} size={12} /> {kind.name}
            </span>
          ))
        ) : (
          <span class="muted">Predict shows the error that this model leaves at each hole.</span>
        )}
      </footer>
    </section>
  );
}

function label(
  context: CanvasRenderingContext2D,
  words: string,
  x: number,
  y: number,
  width: number,
  ink: string,
  ground: string,
): void {
  context.font = "600 12px 'IBM Plex Sans Variable', system-ui, sans-serif";
  const long = context.measureText(words).width;
  const left = x + 18 + long > width - 8 ? x - 18 - long : x + 18;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillStyle = ground;
  context.globalAlpha = 0.85;
  context.fillRect(left - 4, y - 10, long + 8, 20);
  context.globalAlpha = 1;
  context.fillStyle = ink;
  context.fillText(words, left, y);
}

function TouchPanel({model}: {model: SheetModel}) {
  const suggested = (proposals.value.document?.next_readings ?? []).map((reading) => ({
    hole: holeOf(model, reading.point),
    joints: reading.joints,
  }));
  const done = touches.value;
  const open = suggested.filter((entry) => entry.hole >= 0 && !done.some((touch) => touch.hole === entry.hole));
  const own =
    picked.value >= 0 &&
    !done.some((touch) => touch.hole === picked.value) &&
    !open.some((entry) => entry.hole === picked.value);
  return (
    <section class="panel">
      <header>
        <h2>{done.length === 0 ? "Three holes to touch" : `${done.length} touched`}</h2>
        <div class="end">
          <button
            class="button"
            disabled={runningJob("touches") !== null}
            onClick={() => runJob("Which holes to touch", "/api/touches", {goal: "base"})}
          >
            Suggest
          </button>
        </div>
      </header>
      <div class="panel-body touch-list">
        {done.map((touch, index) => (
          <div class="touch-row done" key={`${index}-${touch.hole}`}>
            <b>T{index + 1}</b>
            <span>{holeName(model, touch.hole)}</span>
            <span class="joint-list">{touch.joints.map((value) => fixed(value, 2)).join("  ")}</span>
            <button class="tool" title="Take this touch away" onClick={() => takeAway(index)}>
              <Icon name="close" size={14} />
            </button>
          </div>
        ))}
        {open.map((entry) => (
          <TouchForm key={entry.hole} name={holeName(model, entry.hole)} hole={entry.hole} />
        ))}
        {own ? <TouchForm key={picked.value} name={holeName(model, picked.value)} hole={picked.value} /> : null}
        {done.length + open.length === 0 && !own ? (
          <p class="muted">Suggest rings the three holes that tell most, or pick one on the sheet.</p>
        ) : null}
        <button
          class="button first"
          disabled={done.length < 3 || runningJob("calibrate") !== null}
          onClick={() => void calibrate()}
        >
          {done.length < 3 ? `Calibrate (${3 - done.length} more)` : "Calibrate"}
        </button>
      </div>
    </section>
  );
}

/** The base once found, the error that its doubt leaves is worked out anew. */
async function calibrate(): Promise<void> {
  if (await runJob("Calibrate", "/api/calibrate")) await runJob("Predicted error", "/api/field", {of: "centring"});
}

function takeAway(index: number): void {
  remove(`/api/touch/${index}`).catch((error) => report("The touch stays", error));
}

function TouchForm({name, hole}: {name: string; hole: number}) {
  const joints = cell.value?.joints ?? [];
  const touch = (body: object) => order(`Touch of ${name}`, "/api/touch", {hole, ...body});
  return (
    <form
      class="touch-row"
      onSubmit={(event) => {
        event.preventDefault();
        const values = joints.map((joint) => Number(new FormData(event.currentTarget).get(joint.name)));
        void touch({joints: values});
      }}
    >
      <span>{name}</span>
      <span class="joint-inputs">
        {joints.map((joint) => (
          <input
            name={joint.name}
            inputMode="decimal"
            placeholder={joint.name}
            aria-label={`${joint.name} at ${name}`}
            required
          />
        ))}
      </span>
      <span class="touch-buttons">
        <button class="button" type="submit">
          Enter
        </button>
        <button class="button" type="button" onClick={() => touch({simulate: true})}>
          Simulate
        </button>
      </span>
    </form>
  );
}

function BasePanel() {
  const found = outcome.value;
  if (found.problem)
    return (
      <section class="panel grow">
        <div class="panel-body">
          <ProblemWords problem={found.problem} />
        </div>
      </section>
    );
  const document = found.document;
  if (!document) {
    return (
      <section class="panel grow">
        <header>
          <h2>Base</h2>
        </header>
        <div class="panel-body">
          <p class="muted">
            Where the base stands, what is left at each touch and how sure that is, once three holes are touched.
          </p>
        </div>
      </section>
    );
  }
  const {length, angle} = units.value;
  return (
    <section class="panel grow">
      <header>
        <h2>Base</h2>
        <div class="end">
          <span class="muted">
            rms {short(document.rms)} {length}
          </span>
        </div>
      </header>
      <div class="panel-body">
        <table>
          <thead>
            <tr>
              <th />
              <th class="number">x</th>
              <th class="number">y</th>
              <th class="number">z</th>
            </tr>
          </thead>
          <tbody>
            <tr>
              <th>position, {length}</th>
              {document.base.position.map((value) => (
                <td class="number">{fixed(value, 4)}</td>
              ))}
            </tr>
            <tr>
              <th>± sigma</th>
              {document.sigma.position.map((value) => (
                <td class="number">{fixed(value, 4)}</td>
              ))}
            </tr>
            <tr>
              <th>turn, {angle}</th>
              {document.base.rpy.map((value) => (
                <td class="number">{fixed(value, 4)}</td>
              ))}
            </tr>
            <tr>
              <th>± sigma</th>
              {document.sigma.rotation.map((value) => (
                <td class="number">{fixed(value, 4)}</td>
              ))}
            </tr>
          </tbody>
        </table>
        <h3>Left at each touch, {length}</h3>
        <table>
          <tbody>
            {document.residuals.map((touch) => (
              <tr>
                <td>{touch.id}</td>
                <td>{touch.hole}</td>
                {touch.residual.map((value) => (
                  <td class="number">{fixed(value, 4)}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
        <h3>Distances by arm and sheet, {length}</h3>
        <table>
          <tbody>
            {document.distances.map((row) => (
              <tr>
                <td>
                  {row.from} to {row.to}
                </td>
                <td class="number">{fixed(row.by_arm, 3)}</td>
                <td class="number">{fixed(row.on_sheet, 3)}</td>
                <td class="number">{fixed(row.difference, 4)}</td>
              </tr>
            ))}
          </tbody>
        </table>
        <h3>Correlations of the base's numbers</h3>
        <Covariance matrix={document.covariance} />
        {document.reason ? <p class="muted">{document.reason}</p> : null}
      </div>
    </section>
  );
}
