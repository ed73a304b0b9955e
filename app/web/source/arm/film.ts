// Film of the 3-D picture while it moves, drawn larger than on the screen, with words over it.
import {effect, type ReadonlySignal, signal} from "@preact/signals";
import {TYPEFACE} from "../drawing/canvas";
import {palette} from "../drawing/colours";
import type {ArmStage} from "./arm_stage";
import {withDuration} from "./film_duration";
import {download, nameOf} from "./picture_file";

const KINDS: readonly (readonly [string, string])[] = [
  ["video/webm;codecs=vp9", "webm"],
  ["video/webm;codecs=vp8", "webm"],
  ["video/mp4", "mp4"],
];
const WIDTH = 1280; // width of a film [pixels]
const PICTURES = 30; // largest number of pictures a second
const TEXT = 26; // height of the words [pixels]

/** Returns the film format that this browser can record; null if it can record none. */
function filmKind(): readonly [string, string] | null {
  if (typeof MediaRecorder === "undefined") return null;
  return KINDS.find(([type]) => MediaRecorder.isTypeSupported(type)) ?? null;
}

/** Length of a film so far [s], and the number of its pictures. */
export interface FilmLength {
  seconds: number;
  pictures: number;
}

export interface Film {
  length: ReadonlySignal<FilmLength>;
  /** Ends the film and saves it. */
  end: () => void;
}

/** Saved film: its file, its length [s] and its size [bytes]. */
export interface SavedFilm {
  name: string;
  seconds: number;
  bytes: number;
}

/** Returns a canvas of the film's width with the proportions of the stage, and with an even height for the encoder. */
function filmCanvas({canvas: {clientWidth, clientHeight}}: ArmStage): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [WIDTH, 2 * Math.round((WIDTH * clientHeight) / clientWidth / 2)];
  return canvas;
}

function drawWords(context: CanvasRenderingContext2D, words: string): void {
  context.font = `600 ${TEXT}px ${TYPEFACE}`;
  const {width} = context.measureText(words);
  Object.assign(context, {textBaseline: "middle", fillStyle: palette.peek().panel, globalAlpha: 0.85});
  context.fillRect(0, 0, width + 2 * TEXT, 2 * TEXT);
  Object.assign(context, {fillStyle: palette.peek().ink, globalAlpha: 1});
  context.fillText(words, TEXT, TEXT);
}

/** Saves a recorded film under a name of the opened cell. */
async function save(parts: Blob[], [mimeType, ending]: readonly [string, string], seconds: number): Promise<SavedFilm> {
  const bytes = new Uint8Array(await new Blob(parts).arrayBuffer());
  const film = ending === "webm" ? withDuration(bytes, 1000 * seconds) : bytes,
    name = nameOf("path", ending);
  download(new Blob([film], {type: mimeType.split(";")[0]}), name);
  return {name, seconds, bytes: film.length};
}

/**
 * Starts a film of the stage with the current words, and calls `onSaved` when it is saved; returns null if the browser
 * does not support recording.
 */
export function beginFilm(stage: ArmStage, words: () => string, onSaved: (film: SavedFilm) => void): Film | null {
  const kind = filmKind();
  if (!kind) return null;
  const canvas = filmCanvas(stage),
    context = canvas.getContext("2d")!;
  const length = signal<FilmLength>({seconds: 0, pictures: 0}),
    start = performance.now();
  const secondsNow = () => (performance.now() - start) / 1000;
  const endStage = stage.beginFilm(palette.peek().panel, WIDTH, () => {
    context.drawImage(stage.canvas, 0, 0, canvas.width, canvas.height);
    drawWords(context, words());
    length.value = {seconds: secondsNow(), pictures: length.peek().pictures + 1};
  });
  const endWords = effect(() => void (words(), stage.requestFrame()));
  const recorder = new MediaRecorder(canvas.captureStream(PICTURES), {
    mimeType: kind[0],
    videoBitsPerSecond: 8_000_000,
  });
  const parts: Blob[] = [];
  recorder.addEventListener("dataavailable", ({data}) => parts.push(data));
  recorder.addEventListener("stop", async () => {
    endWords();
    endStage();
    onSaved(await save(parts, kind, secondsNow()));
  });
  recorder.start(1000);
  return {length, end: () => recorder.state !== "inactive" && recorder.stop()};
}
