// Storage in this browser, by name: objects that may be missing, damaged or written by an earlier version.

export function keptObject<T>(key: string): Record<string, T> {
  try {
    const kept = JSON.parse(localStorage.getItem(key) ?? "{}");
    return kept !== null && typeof kept === "object" && !Array.isArray(kept) ? kept : {};
  } catch {
    return {};
  }
}

export function keep<T>(key: string, object: Record<string, T>): void {
  try {
    localStorage.setItem(key, JSON.stringify(object));
  } catch {
    // Without storage, the page asks again every time.
  }
}
