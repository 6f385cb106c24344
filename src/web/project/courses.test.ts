import { describe, expect, it } from 'vitest';

import { boardTypes } from '#board/boards/index';
import { checkForDevice } from '#device-check/check-for-device';

import { courses, examples } from './courses';

const firmware = boardTypes[0]!.firmwares[0];

describe('the programs that come with the app', () => {
  it('have nothing that the device check would mark on the micro:bit, so a first visit need not load it', () => {
    const programs = [...courses.map(({ program }) => program), ...examples.map(({ source }) => source)];
    expect(programs.length).toBeGreaterThan(3);
    for (const program of programs) expect(checkForDevice({ 'main.py': program }, firmware), program).toEqual([]);
  });
});
