import type { Watcher } from './news';

/**
 * A sensor counts as on the line until it has been off it for so long, in ms. Chosen: a robot that follows a line
 * leaves it with one sensor or the other several times a second and is on it all the while.
 */
const OFF_AFTER_MS = 600;

/**
 * Finds out which sensors come onto the line, and when it is lost. At the start there is no news: the words of the
 * start say it.
 */
export function watchLine(): Watcher {
  const lastOn = new Map<string, number>();
  let before: string | null = null;
  return (seen) => {
    for (const { name, isDark } of seen.lineSensors) if (isDark) lastOn.set(name, seen.atMs);
    const names = seen.lineSensors
      .map(({ name }) => name)
      .filter((name) => seen.atMs - (lastOn.get(name) ?? -Infinity) < OFF_AFTER_MS);
    const now = names.join();
    const isNews = before !== null && before !== now;
    before = now;
    return isNews ? [{ topic: 'line', names, seen }] : [];
  };
}
