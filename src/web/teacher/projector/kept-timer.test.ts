// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';

import { readTimer, writeTimer } from './kept-timer';

const timer = { setMs: 300_000, leftMs: 120_000, endsMs: 1_800_000_000_000 };
const put = (text: string): void => sessionStorage.setItem('parcours.projector', text);

describe('what a tab keeps of the timer', () => {
  beforeEach(() => sessionStorage.clear());

  it('is nothing on a first visit', () => expect(readTimer()).toEqual({ timer: null, hasSound: false }));

  it('comes back as it was', () => {
    writeTimer({ timer, hasSound: true });
    expect(readTimer()).toEqual({ timer, hasSound: true });
  });

  it.each([
    '{',
    '7',
    '{"timer":7}',
    '{"timer":{"setMs":"5","leftMs":0,"endsMs":null}}',
    '{"timer":{"setMs":1e12,"leftMs":0,"endsMs":null}}',
    '{"timer":{"setMs":60000,"leftMs":-1,"endsMs":null}}',
    '{"timer":{"setMs":60000,"leftMs":1,"endsMs":"soon"}}',
  ])('is nothing where it reads %s', (text) => {
    put(text);
    expect(readTimer()).toEqual({ timer: null, hasSound: false });
  });
});
