import { describe, expect, it } from 'vitest';

import { noticePlace, type NoticeRoom } from './notice-place';

const room = (name: string, part: Partial<NoticeRoom> = {}): NoticeRoom => ({
  ...{ name, left: 600, top: 100, width: 700, height: 500 },
  ...part,
});

describe('the place of a message', () => {
  it('is along the upper edge of the arena, whatever else is in sight', () => {
    const rooms = [room('code', { left: 0 }), room('arena'), room('console', { top: 700 })];
    expect(noticePlace(rooms)).toEqual({ left: 600, top: 104, width: 700 });
  });

  it('is over the console, otherwise over the program, where there is no arena', () => {
    expect(noticePlace([room('board'), room('code', { top: 50 }), room('console', { top: 700 })])?.top).toBe(704);
    expect(noticePlace([room('board'), room('code', { top: 50 })])?.top).toBe(54);
  });

  it('is not where a message would come to the middle, nor where nothing is in sight', () => {
    expect(noticePlace([room('arena', { height: 120 })])).toBeNull();
    expect(noticePlace([room('arena', { width: 200 }), room('code', { left: 5 })])?.left).toBe(5);
    expect(noticePlace([room('arena', { width: 0, height: 0 })])).toBeNull();
  });
});
