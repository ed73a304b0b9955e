// Encoder readings of a running arm, which move the displayed arm while this browser follows.
import {effect, signal} from "@preact/signals";
import {liveNews} from "../server/workbench";
import {bringArm} from "./pose_link";

/** Time without data after which the running arm is assumed to be disconnected or at rest [ms]. */
const SILENCE = 3000;

export const isFollowing = signal(true);
/** True if a running arm reports its posture. */
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
