// Sharing of equal parts of two successive answers as the same object, so that observers of a part are not notified of
// changes elsewhere.

function isParted(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null;
}

/** Returns `next` with its equal parts replaced by the objects of `before`; `before` itself if all parts are equal. */
export function sharing<T>(before: unknown, next: T): T {
  if (Object.is(before, next) || !isParted(before) || !isParted(next) || Array.isArray(before) !== Array.isArray(next))
    return next;
  const shared = Object.entries(next).map(([key, part]) => [key, sharing(before[key], part)] as const);
  const isSame =
    shared.length === Object.keys(before).length &&
    shared.every(([key, part]) => key in before && part === before[key]);
  if (isSame) return before as T;
  return (Array.isArray(next) ? shared.map(([, part]) => part) : Object.fromEntries(shared)) as T;
}
