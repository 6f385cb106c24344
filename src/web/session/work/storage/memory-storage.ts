/** A storage like the browser's that lasts as long as the page is open. */
export function memoryStorage(): Storage {
  const all = new Map<string, string>();
  return {
    get length() {
      return all.size;
    },
    key: (index) => [...all.keys()][index] ?? null,
    getItem: (key) => all.get(key) ?? null,
    setItem: (key, value) => void all.set(key, value),
    removeItem: (key) => void all.delete(key),
    clear: () => all.clear(),
  };
}

/** The browser's storage; if the browser forbids it, one for this visit. */
export function pageStorage(): Storage {
  try {
    return localStorage;
  } catch {
    return memoryStorage();
  }
}
