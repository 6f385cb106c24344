import { describe, expect, it } from 'vitest';

import { noticePlace, type NoticeRoom } from './notice-place';

const room = (name: string, part: Partial<NoticeRoom> = {}): NoticeRoom => ({
  ...{ name, left: 600, top: 100, width: 700, height: 500 },
  ...part,
});

describe('the place of a message', () => {
  it('is along the lower edge of the program, whatever else is in sight', () => {
    const rooms = [room('arena'), room('code', { left: 0 }), room('console', { top: 700 })];
    expect(noticePlace(rooms)).toEqual({ left: 0, width: 700, at: { bottom: 596 } });
  });

  it('is over the console where there is no program, and in the arena, at its upper edge, where nothing else is', () => {
    expect(noticePlace([room('board'), room('arena'), room('console', { top: 700 })])?.at).toEqual({ top: 704 });
    expect(noticePlace([room('arena'), room('board', { top: 50 })])?.at).toEqual({ top: 54 });
    expect(noticePlace([room('arena')])?.at).toEqual({ top: 104 });
  });

  it('is not where a message would come to the middle, nor where nothing is in sight', () => {
    expect(noticePlace([room('code', { height: 120 })])).toBeNull();
    expect(noticePlace([room('code', { width: 200 }), room('console', { left: 5 })])?.left).toBe(5);
    expect(noticePlace([room('arena', { width: 0, height: 0 })])).toBeNull();
  });
});
