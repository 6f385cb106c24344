/** Messages between tabs of one browser about the stored class: it was written, or is no longer stored. */
export type ClassNews = 'written' | 'ended';

/** The other tabs. */
export interface ClassTabs {
  tell(news: ClassNews): void;
  hear(told: (news: ClassNews) => void): void;
}

/**
 * The other tabs of this browser; where they cannot be reached, a tab still sees what they have written when it writes
 * itself.
 */
export function classTabs(): ClassTabs {
  if (typeof BroadcastChannel === 'undefined') return { tell: () => undefined, hear: () => undefined };
  const channel = new BroadcastChannel('parcours.class');
  return {
    tell: (news) => channel.postMessage(news),
    hear: (told) => channel.addEventListener('message', ({ data }: MessageEvent<ClassNews>) => told(data)),
  };
}
