const KEY = 'parcours.device-programs';
const KEPT = 60; // chosen: a school year of one pupil's last programs, 2 kB

/** The programs that this browser has put on devices. Such files may be replaced without asking. */
export interface KnownPrograms {
  has(fingerprint: string): boolean;
  add(fingerprints: readonly string[]): void;
}

/** @param storage keeps them; if it refuses, they are remembered until the page is closed */
export function knownPrograms(storage: Pick<Storage, 'getItem' | 'setItem'>): KnownPrograms {
  let known = read(storage);
  return {
    has: (fingerprint) => known.includes(fingerprint),
    add: (fingerprints) => {
      known = [...new Set([...fingerprints, ...known])].slice(0, KEPT);
      try {
        storage.setItem(KEY, JSON.stringify(known));
      } catch {
        // Full or forbidden: the next visit will ask again.
      }
    },
  };
}

function read(storage: Pick<Storage, 'getItem'>): readonly string[] {
  try {
    const kept: unknown = JSON.parse(storage.getItem(KEY) ?? '[]');
    return Array.isArray(kept) ? kept.filter((entry) => typeof entry === 'string').slice(0, KEPT) : [];
  } catch {
    return [];
  }
}
