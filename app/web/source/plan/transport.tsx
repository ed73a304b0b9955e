// Controls of the playback: play, pause, position, speed.
import {effect, signal} from "@preact/signals";
import {openStage} from "../arm/arm_stage";
import {beginFilm, type Film, type SavedFilm} from "../arm/film";
import {Segments} from "../drawing/segments";
import {Icon} from "../drawing/icons";
import {clock, duration, MISSING, plural, short} from "../../../drawing/numbers.js";
import {tubeTitle} from "../../../drawing/sheet_model.js";
import {inform, report, units} from "../server/workbench";
import {filmSpeed} from "./film_speed";
import {currentVisit, endTime, goToVisit, isPlaying, path, plan, play, speed, time, togglePlay} from "./playback";
import {sampleAt} from "./sampling";

const FACTORS = [1, 4, 16, 64];
const SPEEDS = FACTORS.map((factor) => ({value: factor, words: `×${factor}`}));

function keys(event: KeyboardEvent): void {
  if (event.key === " ") togglePlay();
  else if (event.key === "ArrowRight") goToVisit(currentVisit.value + 1);
  else if (event.key === "ArrowLeft") goToVisit(currentVisit.value - 1);
  else if (event.key === "Home") time.value = 0;
  else return;
  event.preventDefault();
}

/** Film that is being recorded; null if there is none. */
const film = signal<Film | null>(null);

/** Returns the words over a film, such as "00:12.5 of 03:00.0   R12 C30   2 of 60". */
function filmWords(): string {
  const tubes = plan.value.document?.tubes ?? [],
    tube = tubes[currentVisit.value];
  const place = tube ? [tubeTitle(tube.row, tube.column), `${currentVisit.value + 1} of ${tubes.length}`] : [];
  return [`${clock(time.value)} of ${clock(endTime.value)}`, ...place].join("   ");
}

function tellSaved({name, seconds, bytes}: SavedFilm): void {
  inform("Film saved", `${name}: ${duration(seconds)}, ${short(bytes / 1e6)} MB`);
}

/** Starts or stops a video recording of the playback. */
function toggleFilm(): void {
  if (film.value) {
    isPlaying.value = false;
    return;
  }
  film.value = openStage.peek() ? beginFilm(openStage.peek()!, filmWords, tellSaved) : null;
  if (!film.value)
    return report("No film", {
      message: "This browser records no films of pictures.",
      advice: "Try Chromium or Firefox.",
    });
  speed.value = filmSpeed(endTime.value, speed.value, FACTORS);
  play();
}

// A film ends with the playback.
effect(() => {
  if (isPlaying.value) return;
  film.peek()?.end();
  film.value = null;
});

/** Red dot with the length of the film that is being recorded and the number of its pictures. */
function Recording({film: {length}}: {film: Film}) {
  const {seconds, pictures} = length.value;
  return (
    <span class="recording">
      <i aria-hidden="true" />
      <span class="clock">{clock(seconds)}</span> {plural(pictures, "picture")}
    </span>
  );
}

export function Transport() {
  const document = path.value,
    tubes = plan.value.document?.tubes ?? [];
  const tube = tubes[currentVisit.value];
  const sample = document ? sampleAt(document.time, time.value) : 0;
  return (
    <section class="panel transport" onKeyDown={keys}>
      <button class="tool" title="To the start (Home)" disabled={!document} onClick={() => (time.value = 0)}>
        <Icon name="back" />
      </button>
      <button
        class="tool play"
        title="Play or pause (Space)"
        disabled={!document}
        aria-pressed={isPlaying.value}
        onClick={togglePlay}
      >
        <Icon name={isPlaying.value ? "pause" : "play"} size={20} />
        <span class="hidden">{isPlaying.value ? "Pause" : "Play"}</span>
      </button>
      <Segments label="Speed" choices={SPEEDS} value={speed.value} onChoose={(factor) => (speed.value = factor)} />
      <span class="clock">{clock(time.value)}</span>
      <input
        type="range"
        aria-label="Time along the tour"
        min={0}
        max={endTime.value || 1}
        step={0.05}
        value={time.value}
        disabled={!document}
        onInput={(event) => (time.value = Number(event.currentTarget.value))}
      />
      <span class="clock muted">{clock(endTime.value)}</span>
      <button
        class={`button small ${film.value ? "first" : ""}`}
        title="Save the arm in the picture as a film, until the end or until it is stopped, at a speed at which the whole path takes a minute at most"
        aria-pressed={film.value !== null}
        disabled={!document || !openStage.value}
        onClick={toggleFilm}
      >
        Film
      </button>
      {film.value ? <Recording film={film.value} /> : null}
      <span class="now-words">
        <b>{tube ? tubeTitle(tube.row, tube.column) : MISSING}</b>
        <span class="muted">{tubes.length > 0 ? `${Math.max(0, currentVisit.value) + 1} / ${tubes.length}` : ""}</span>
        <span class="muted">{document?.kind[sample] ?? ""}</span>
        <span class="muted">
          {typeof document?.clearance?.[sample] === "number"
            ? `clearance ${short(document.clearance[sample])} ${units.value.length}`
            : ""}
        </span>
      </span>
    </section>
  );
}
