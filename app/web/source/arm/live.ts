// A running arm: what its encoders say moves the arm of this browser, as long as it follows.
import {effect, signal} from "@preact/signals";
import {liveNews} from "../server/workbench";
import {bringArm} from "./pose_link";

/** After so long without a word the arm is taken to stand still, or to be gone [ms]. */
const SILENCE = 3000;

export const isFollowing = signal(true);
/** Whether a running arm reports where it is. */
export const isLive = signal(false);

let silence: ReturnType<typeof setTimeout> | undefined;

effect(() => {
  const news = liveNews.value;
  if (!news?.joints) return;
  clearTimeout(silence);
  silence = setTimeout(() => (isLive.value = false), SILENCE);
  isLive.value = true;
});

effect(() => {
  const {joints, load} = liveNews.value ?? {};
  if (!joints || !isFollowing.value) return;
  bringArm(joints, load);
});
