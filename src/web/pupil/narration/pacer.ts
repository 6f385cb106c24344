import type { News, Topic } from './news';

/**
 * Shortest time between the beginnings of two sentences, in ms. Chosen: a screen reader says six words in two seconds.
 */
export const GAP_MS = 2000;

/** The most important first. */
const ORDER: readonly Topic[] = [
  'touch',
  'target',
  'checkpoint',
  'block',
  'start',
  'line',
  'colour',
  'camera',
  'ahead',
  'turn',
  'rest',
];

/**
 * After so long in the queue an event is no news any more, in ms. A state (line, ahead) is announced as it is by then.
 */
const STALE_MS: Readonly<Record<Topic, number>> = {
  ...{ touch: 5000, target: 10_000, checkpoint: 10_000, block: 10_000, start: 5000 },
  ...{ line: Infinity, colour: 4000, camera: Infinity, ahead: Infinity, turn: 5000, rest: 6000 },
};

/**
 * Shortest time between two sentences on a topic, in ms: what goes on and off all the time must not talk down the rest.
 */
const REST_MS: Readonly<Record<Topic, number>> = {
  ...{ touch: 4000, target: 0, checkpoint: 0, block: 0, start: 0 },
  ...{ line: 4000, colour: 0, camera: 4000, ahead: 0, turn: 0, rest: 4000 },
};

/** Lets news out one by one, at a pace that can be followed. Times by the clock on the wall, in ms. */
export interface Pacer {
  /** Queues a piece of news. It takes the place of what still waited on its topic. */
  offer(news: News, nowMs: number): void;
  /**
   * The text to announce now, if any.
   *
   * @param words the text on a piece of news now; `null`: it is not so any more
   */
  next(nowMs: number, words: (news: News) => string | null): string | null;
  /** Announces nothing until then: something else is said. */
  letSpeak(untilMs: number): void;
  /** Empties the queue. */
  clear(): void;
  readonly isWaiting: boolean;
}

export function createPacer(): Pacer {
  const waiting = new Map<Topic, { readonly news: News; readonly sinceMs: number }>();
  const told = new Map<Topic, { readonly atMs: number; readonly words: string }>();
  let freeFromMs = -Infinity;
  let last: string | null = null;

  /**
   * The text that new words on a topic must differ from: states are announced when they change, events may be repeated
   * (`null`).
   */
  function before(topic: Topic): string | null {
    if (topic === 'rest') return last;
    return topic === 'line' || topic === 'camera' ? (told.get(topic)?.words ?? null) : null;
  }

  /** The words of a topic, if they are new. */
  function newWords(topic: Topic, words: (news: News) => string | null): string | null {
    const news = waiting.get(topic)?.news;
    const now = news === undefined ? null : words(news);
    return now === before(topic) ? null : now;
  }

  return {
    offer: (news, nowMs) => void waiting.set(news.topic, { news, sinceMs: nowMs }),
    next(nowMs, words) {
      for (const [topic, { sinceMs }] of waiting) if (nowMs - sinceMs > STALE_MS[topic]) waiting.delete(topic);
      if (nowMs < freeFromMs) return null;
      for (const topic of ORDER) {
        if (!waiting.has(topic) || nowMs - (told.get(topic)?.atMs ?? -Infinity) < REST_MS[topic]) continue;
        const now = newWords(topic, words);
        waiting.delete(topic);
        if (now === null) continue;
        told.set(topic, { atMs: nowMs, words: now });
        last = now;
        freeFromMs = nowMs + GAP_MS;
        return now;
      }
      return null;
    },
    letSpeak: (untilMs) => void (freeFromMs = Math.max(freeFromMs, untilMs)),
    clear: () => waiting.clear(),
    get isWaiting() {
      return waiting.size > 0;
    },
  };
}
