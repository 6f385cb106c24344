import type { RadioEntry } from '../../../session/run/radio-model';

/** Time for which a packet is shown, in simulated µs. Chosen: long enough to read a word. */
const SEEN_US = 800_000;

/** The last packet of each device's program, if it was sent a moment ago. */
export function newestPackets(entries: readonly RadioEntry[], nowUs: number): readonly RadioEntry[] {
  const newest = new Map<number, RadioEntry>();
  for (let i = entries.length - 1; i >= 0; i--) {
    const entry = entries[i];
    if (entry === undefined || entry.timeUs < nowUs - SEEN_US) break;
    if (entry.from === 'program' && !newest.has(entry.device)) newest.set(entry.device, entry);
  }
  return [...newest.values()].reverse();
}
