// The effects that this arm can have: laws, numbers with their usual sizes, places, and which of them the readings that
// are open could hardly distinguish.
import {computed, effect as follow, signal} from "@preact/signals";
import {isNumber, percent, plural, short} from "../../../drawing/numbers.js";
import {currentDiagnosis} from "../error/loop";
import type {CatalogueDocument, ConfoundingDocument} from "../server/documents";
import {get} from "../server/requests";
import {cell, report, state} from "../server/workbench";
import {view} from "../shell/page_state";
import {Waiting} from "../shell/states";
import {SignaturePicture} from "./signature_picture";
import {filteredKinds, kindsOf, type EffectKind, type EffectPlace} from "./effect_kinds";

const catalogue = signal<CatalogueDocument | null>(null);
const confounding = signal<ConfoundingDocument | null>(null);
const chosen = signal("");
const filter = signal("");
/** The place whose signature is drawn, while the effect has it. */
const drawnPlace = signal("");

/** Asked anew for another model or other readings, while one looks. */
function whileLooking<T>(path: string, into: typeof catalogue | typeof confounding, keyOf: () => string): void {
  const key = computed(() => (view.value === "effects" && state.value ? keyOf() : ""));
  let fetched = "";
  follow(() => {
    const wanted = key.value;
    if (wanted === "" || wanted === fetched) return;
    fetched = wanted;
    into.value = null;
    if (wanted === "none") return;
    get<T>(path).then(
      (document) => {
        if (fetched === wanted) (into as {value: T | null}).value = document;
      },
      (error) => report("The effects", error),
    );
  });
}
const modelKey = () => `${state.value!.folder} ${cell.value?.file} ${state.value!.model}`;
whileLooking<CatalogueDocument>("/api/catalogue", catalogue, modelKey);
whileLooking<ConfoundingDocument>("/api/confounding", confounding, () => {
  const readings = state.value!.measurements;
  return readings ? `${modelKey()} ${readings.name} ${readings.change}` : "none";
});

const kinds = computed(() =>
  catalogue.value ? kindsOf(catalogue.value, confounding.value, currentDiagnosis.value) : ([] as EffectKind[]),
);

export function EffectsView() {
  if (!catalogue.value) return <Waiting words="Asking for the effects of this arm" isBusy />;
  const shown = filteredKinds(kinds.value, filter.value);
  const kind = shown.find(({effect}) => effect === chosen.value) ?? shown[0];
  return (
    <div class="effects-view">
      <section class="panel">
        <header>
          <h2>{plural(kinds.value.length, "effect")} on this arm</h2>
          <div class="end">
            <input
              aria-label="Filter the effects"
              placeholder="theta3   moment   gear"
              value={filter.value}
              spellcheck={false}
              onInput={(event) => (filter.value = event.currentTarget.value)}
            />
          </div>
        </header>
        <div class="panel-body flush">
          <ul class="effect-list" role="listbox" aria-label="Effects" onKeyDown={(event) => step(event, shown)}>
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
            {shown.length === 0 ? <li class="muted pad">None has all of these words.</li> : null}
          </ul>
        </div>
      </section>
      {kind ? <KindPanel kind={kind} /> : null}
    </div>
  );
}

function step(event: KeyboardEvent, shown: EffectKind[]): void {
  const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
  if (by === 0) return;
  event.preventDefault();
  const now = Math.max(
    0,
    shown.findIndex(({effect}) => effect === chosen.value),
  );
  const next = shown[Math.min(shown.length - 1, Math.max(0, now + by))];
  if (next) chosen.value = next.effect;
  const list = event.currentTarget as HTMLElement;
  requestAnimationFrame(() => list.querySelector<HTMLElement>("[aria-selected=true]")?.focus());
}

function KindPanel({kind}: {kind: EffectKind}) {
  const place = kind.places.find(({at}) => at === drawnPlace.value) ?? kind.places[0];
  return (
    <section class="panel">
      <header>
        <h2>{kind.effect}</h2>
        <span class="muted clip">{kind.words}</span>
      </header>
      <div class="panel-body effect-kind">
        <p class="law">{kind.law}</p>
        <dl class="figures">
          {kind.parameters.map((parameter) => (
            <>
              <dt>{parameter.name.replaceAll("_", " ")}</dt>
              <dd>
                {isNumber(parameter.plausible) ? `usually up to ${short(parameter.plausible)}` : ""} {unitOf(parameter)}
              </dd>
            </>
          ))}
          <dt>valid</dt>
          <dd>{kind.validity}</dd>
          <dt>source</dt>
          <dd>{kind.source}</dd>
        </dl>
        {place ? <SignaturePicture effect={kind.effect} at={place.at} /> : null}
        <PlaceTable kind={kind} shown={place?.at ?? ""} />
      </div>
    </section>
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
        {confounding.value
          ? `By ${plural(confounding.value.readings, "reading")} and the numbers that are fitted`
          : "Open readings to see how observable this effect is"}
        {hasLeast ? "" : "; the least size that would be seen, after a diagnosis"}
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

function PlaceRow({
  place,
  own,
  hasLeast,
  isShown,
}: {
  place: EffectPlace;
  own: string;
  hasLeast: boolean;
  isShown: boolean;
}) {
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
                    {other.effect === own ? "" : `${other.effect} at `}
                    {other.at}
                  </span>
                ))}
      </td>
    </tr>
  );
}
