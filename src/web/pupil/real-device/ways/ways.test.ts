import { describe, expect, it } from 'vitest';

import { driveOf, guideFor, offeredWays, type WayFacts } from './ways';

/** A Windows computer with Edge, a micro:bit V2, its MicroPython at hand, and nothing done so far. */
const edge: WayFacts = {
  platform: 'computer',
  usb: 'yes',
  serial: 'yes',
  board: 'microbit-v2',
  hasFirmware: true,
  last: null,
};
const firefox = { ...edge, usb: 'browser', serial: 'browser' } as const;
const frame = { ...edge, usb: 'frame', serial: 'frame' } as const;
const ipad = { ...firefox, platform: 'ipad' } as const;
const android = { ...edge, platform: 'android', serial: 'browser' } as const;

/** The ways in one line: `usb hex serial`, a closed one with its reason: `usb(frame)`. */
const line = (facts: WayFacts): string =>
  offeredWays(facts)
    .map(({ way, hindrance }) => (hindrance === null ? way : `${way}(${hindrance})`))
    .join(' ');

describe('the ways onto a real board', () => {
  it.each<readonly [string, WayFacts, string]>([
    ['Chrome and Edge: cable first', edge, 'usb hex serial'],
    ['Firefox and Safari: the file, and why not the cable', firefox, 'hex usb(browser)'],
    ['a frame without allow="usb; serial"', frame, 'hex usb(frame)'],
    ['a frame with allow="serial" alone', { ...edge, usb: 'frame' }, 'hex serial usb(frame)'],
    ['a frame with allow="usb" alone', { ...edge, serial: 'frame' }, 'usb hex serial(frame)'],
    ['a Chromebook: as a computer', { ...edge, platform: 'chromebook' }, 'usb hex serial'],
    ['an iPad: the app, whatever the browser', ipad, 'hex usb(device)'],
    ['Android: the app before the cable', android, 'hex usb serial(browser)'],
    ['a Calliope mini 3', { ...edge, board: 'calliope-mini-3' }, 'usb hex serial'],
    ['a Calliope mini 1 has another chip at its USB', { ...edge, board: 'calliope-mini-1' }, 'hex serial usb(board)'],
  ])('%s', (_, facts, expected) => expect(line(facts)).toBe(expected));

  it.each<readonly [string, WayFacts, string]>([
    ['hex', { ...edge, last: 'hex' }, 'hex usb serial'],
    ['serial', { ...edge, last: 'serial' }, 'serial usb hex'],
    ['usb, on a tablet', { ...android, last: 'usb' }, 'usb hex serial(browser)'],
    ['usb, but not in this browser', { ...firefox, last: 'usb' }, 'hex usb(browser)'],
  ])('begin with the one that worked last: %s', (_, facts, expected) => expect(line(facts)).toBe(expected));

  it.each<readonly [string, WayFacts, string]>([
    ['with Chrome', edge, 'firmware serial'],
    ['with Chrome, after the program alone was replaced', { ...edge, last: 'serial' }, 'serial firmware'],
    ['with Firefox', firefox, 'firmware usb(browser)'],
    ['in a frame', frame, 'firmware usb(frame)'],
    ['on an iPad', ipad, 'firmware usb(device)'],
  ])('ask once for MicroPython where there is none: %s', (_, facts, expected) => {
    expect(line({ ...facts, hasFirmware: false })).toBe(expected);
  });
});

describe('the guide from the file to the board', () => {
  it.each([
    ['computer', 'microbit-v2', 'drive'],
    ['computer', 'calliope-mini-3', 'drive'],
    ['chromebook', 'microbit-v1', 'chromebook'],
    ['ipad', 'microbit-v2', 'microbit-ipad'],
    ['ipad', 'calliope-mini-1', 'calliope-ipad'],
    ['android', 'microbit-v1', 'microbit-android'],
    ['android', 'calliope-mini-3', 'calliope-android'],
  ] as const)('on this device, for this board: %s, %s → %s', (platform, board, guide) => {
    expect(guideFor(platform, board)).toBe(guide);
  });

  it('names the drive as which the board appears', () => {
    expect([driveOf('microbit-v1'), driveOf('calliope-mini-3')]).toEqual(['MICROBIT', 'MINI']);
  });
});
