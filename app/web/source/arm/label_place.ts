// Place of a label beside a point of a picture.

/** Distance of a label from its point [pixels]. */
const GAP = 10;

/**
 * Returns the left edge of a label at a point [pixels]: to the right of the point, or to its left where the label would
 * leave the picture; never left of the picture.
 */
export function labelLeft(point: number, width: number, pictureWidth: number): number {
  const right = Math.round(point + GAP);
  return right + width <= pictureWidth ? right : Math.max(0, Math.round(point - GAP - width));
}
