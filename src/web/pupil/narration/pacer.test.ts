import { describe, expect, it } from 'vitest';

import type { Moment } from './moment';
import type { News, Topic } from './news';
import { createPacer } from './pacer';

const news = (topic: Topic): News => ({ topic, seen: {} as Moment }) as News;
const topicOf = ({ topic }: News): string => topic;

describe('the pace of what is told', () => {
  it('is one sentence in two seconds', () => {
    const pacer = createPacer();
    pacer.offer(news('turn'), 0);
    pacer.offer(news('ahead'), 0);
    expect([0, 500, 1999, 2000, 4000].map((ms) => pacer.next(ms, topicOf))).toEqual(['ahead', null, null, 'turn', null]); // prettier-ignore
  });

  it('lets the most important come first: what is touched, targets, checkpoints, the line, what is ahead, turns', () => {
    const pacer = createPacer();
    const topics = ['turn', 'ahead', 'line', 'checkpoint', 'target', 'touch'] as const;
    for (const topic of topics) pacer.offer(news(topic), 0);
    const order = [0, 2000, 4000, 6000, 8000].map((ms) => pacer.next(ms, topicOf));
    expect(order).toEqual(['touch', 'target', 'checkpoint', 'line', 'ahead']);
    expect(pacer.next(10_000, topicOf)).toBeNull(); // the turn was too long ago
  });

  it('says things as they are when they are said, and nothing that is no more', () => {
    const pacer = createPacer();
    pacer.offer(news('ahead'), 0);
    expect(pacer.next(0, () => null)).toBeNull();
    expect(pacer.isWaiting).toBe(false);
  });

  it('tells the newest where several of a kind have waited', () => {
    const pacer = createPacer();
    pacer.offer({ ...news('checkpoint'), number: 1 } as News, 0);
    pacer.offer({ ...news('checkpoint'), number: 2 } as News, 0);
    expect(pacer.next(0, (one) => String((one as { number?: number }).number))).toBe('2');
    expect(pacer.next(2000, topicOf)).toBeNull();
  });

  it('does not repeat that the robot is on the line, but each touch that comes some seconds later', () => {
    const pacer = createPacer();
    for (const topic of ['line', 'touch'] as const) {
      pacer.offer(news(topic), 0);
      expect(pacer.next(topic === 'line' ? 0 : 2000, topicOf)).toBe(topic);
    }
    pacer.offer(news('line'), 7000);
    expect(pacer.next(7000, topicOf)).toBeNull();
    pacer.offer(news('touch'), 7000);
    expect(pacer.next(7000, topicOf)).toBe('touch');
  });

  it('says where the robot stands again only after something else', () => {
    const pacer = createPacer();
    const stands = (ms: number) => {
      pacer.offer(news('rest'), ms);
      return pacer.next(ms, topicOf);
    };
    expect([stands(0), stands(5000)]).toEqual(['rest', null]);
    pacer.offer(news('turn'), 10_000);
    pacer.next(10_000, topicOf);
    expect(stands(15_000)).toBe('rest');
  });

  it('waits while somebody else speaks', () => {
    const pacer = createPacer();
    pacer.letSpeak(2000);
    pacer.offer(news('start'), 0);
    expect([1000, 2000].map((ms) => pacer.next(ms, topicOf))).toEqual([null, 'start']);
  });
});
