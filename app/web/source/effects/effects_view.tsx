// The possible effects on this arm: laws, parameters with their usual values, places, and effects that the current
// readings could hardly distinguish.
import {computed, signal} from "@preact/signals";
import {TextInput} from "../drawing/fields";
import {Figures, Panel} from "../drawing/panel";
import {roving} from "../drawing/segments";
import {effectTitle} from "../../../drawing/explanations.js";
import {isNumber, percent, plural, short} from "../../../drawing/numbers.js";
import {currentDiagnosis} from "../error/loop";
import type {CatalogueDocument, ConfoundingDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {cell, reporting, state} from "../server/workbench";
import {view} from "../shell/page_state";
import {Waiting} from "../shell/states";
import {SignaturePicture} from "./signature_picture";
import {filteredKinds, kindsOf, type EffectKind, type EffectPlace} from "./effect_kinds";

const chosen = signal("");
const filter = signal("");
/** Place whose signature is drawn, if the chosen effect can act there. */
const drawnPlace = signal("");

/** Returns the answer to a request, repeated for another model or other readings while the view is open. */
function whileLooking<T>(path: string, keyOf: () => string) {
  const key = () => (view.value === "effects" && state.value ? keyOf() : null);
  return answerTo<T>({key, path: () => path, onProblem: reporting("The effects")});
}
const modelKey = () => `${state.value!.folder} ${cell.value?.file} ${state.value!.model}`;
const catalogue = whileLooking<CatalogueDocument>("/api/catalogue", modelKey),
  confounding = whileLooking<ConfoundingDocument>("/api/confounding", () => {
    const readings = state.value!.measurements;
    return readings ? `${modelKey()} ${readings.name} ${readings.change}` : "";
  });

const kinds = computed(() => {
  const {document} = catalogue.value;
  return document ? kindsOf(document, confounding.value.document, currentDiagnosis.value) : [];
});

export function EffectsView() {
  if (!catalogue.value.document) return <Waiting words="Asking for the effects of this arm" isBusy />;
  const shown = filteredKinds(kinds.value, filter.value);
  const kind = shown.find(({effect}) => effect === chosen.value) ?? shown[0];
  return (
    <div class="effects-view">
      <Panel
        title={`${plural(kinds.value.length, "effect")} on this arm`}
        end={<TextInput of={filter} aria-label="Filter the effects" placeholder="theta3   moment   gear" />}
        body="flush"
      >
        <ul class="effect-list" role="listbox" aria-label="Effects" onKeyDown={step}>
          {shown.map((entry) => (
            <li key={entry.effect} role="presentation">
              <button
                role="option"
                aria-selected={entry === kind}
                tabIndex={entry === kind ? 0 : -1}
                onClick={() => (chosen.value = entry.effect)}
              >
                <b>{entry.effect}</b>
                <span class="muted">{entry.words}</span>
                <small class="muted">{plural(entry.places.length, "place")}</small>
              </button>
            </li>
          ))}
          {shown.length === 0 ? <li class="muted pad">No effect has all of these words.</li> : null}
        </ul>
      </Panel>
      {kind ? <KindPanel kind={kind} /> : null}
    </div>
  );
}

const step = roving({ArrowDown: 1, ArrowUp: -1}, false);

function KindPanel({kind}: {kind: EffectKind}) {
  const place = kind.places.find(({at}) => at === drawnPlace.value) ?? kind.places[0];
  const sizes = kind.parameters.map(({name, plausible, unit}): [string, string] => [
    name.replaceAll("_", " "),
    `${isNumber(plausible) ? `usually up to ${short(plausible)}` : ""} ${unitOf({unit})}`,
  ]);
  return (
    <Panel title={kind.effect} head={<span class="muted clip">{kind.words}</span>} body="effect-kind">
      <p class="law">{kind.law}</p>
      <Figures rows={[...sizes, ["valid", kind.validity], ["source", kind.source]]} />
      {place ? <SignaturePicture effect={kind.effect} at={place.at} /> : null}
      <PlaceTable kind={kind} shown={place?.at ?? ""} />
    </Panel>
  );
}

function unitOf({unit}: {unit: string}): string {
  return unit === "1" ? "" : unit;
}

function PlaceTable({kind, shown}: {kind: EffectKind; shown: string}) {
  const hasLeast = kind.places.some(({least}) => least !== null);
  return (
    <table class="place-table">
      <caption class="muted">
        {confounding.value.document
          ? `By ${plural(confounding.value.document.readings, "reading")} and the numbers that are fitted`
          : "Open readings to see how observable this effect is"}
        {hasLeast ? "" : "; the smallest detectable size, after a diagnosis"}
      </caption>
      <thead>
        <tr>
          <th>at</th>
          <th class="number" title="The part of its signature that the fitted parameters do not absorb">
            observable
          </th>
          {hasLeast ? <th class="number">smallest detectable</th> : null}
          <th>hardly distinguished from</th>
        </tr>
      </thead>
      <tbody>
        {kind.places.map((place) => (
          <PlaceRow key={place.at} place={place} own={kind.effect} hasLeast={hasLeast} isShown={place.at === shown} />
        ))}
      </tbody>
    </table>
  );
}

const HARDLY = 0.05;

interface PlaceRowProps {
  place: EffectPlace;
  own: string;
  hasLeast: boolean;
  isShown: boolean;
}

function PlaceRow({place, own, hasLeast, isShown}: PlaceRowProps) {
  const {at, kept, least, confounded: others} = place;
  return (
    <tr>
      <td>
        <button class="link" aria-pressed={isShown} title="Draw it here" onClick={() => (drawnPlace.value = at)}>
          {at}
        </button>
      </td>
      <td class="number">
        {kept === null ? "–" : <span class={kept < HARDLY ? "bad" : ""}>{percent(kept, kept < 0.1 ? 1 : 0)}</span>}
      </td>
      {hasLeast ? (
        <td class={`number ${least?.isBeyondUsual ? "bad" : ""}`}>
          {least && isNumber(least.size) ? `${short(least.size)} ${unitOf(least)}` : "–"}
        </td>
      ) : null}
      <td class="confounded">
        {kept === null
          ? "–"
          : kept < 1e-3
            ? "the fitted numbers"
            : others.length === 0
              ? "nothing"
              : others.map((other) => (
                  <span title={`${percent(other.share, 1)} of what is left of it`}>
                    {other.effect === own ? other.at : effectTitle(other)}
                  </span>
                ))}
      </td>
    </tr>
  );
}
