import { readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { boardTypes } from '#board/boards/index';
import { findRobot, robotTypes } from './index';

const LONGEST_FILE_NAME = 120; // the board's file system

describe('the list of robots', () => {
  it('has every folder in src/robots, once', () => {
    const folders = readdirSync('src/robots', { withFileTypes: true }).filter((entry) => entry.isDirectory());
    expect(robotTypes.map((type) => type.id).sort()).toEqual(folders.map((folder) => folder.name).sort());
  });

  it('finds a robot by its id and gives null for a stranger', () => {
    for (const type of robotTypes) expect(findRobot(type.id)).toBe(type);
    expect(findRobot('toaster')).toBeNull();
  });
});

describe.each(robotTypes.map((type) => [type.name, type] as const))('%s', (_, type) => {
  it('plugs into a board that exists', () => {
    expect(boardTypes.map((board) => board.id)).toContain(type.board);
  });

  it('has an outline of convex parts with 3 to 12 corners, counter-clockwise', () => {
    expect(type.body.outlineMm.length).toBeGreaterThan(0);
    for (const part of type.body.outlineMm) {
      expect(part.length).toBeGreaterThanOrEqual(3);
      expect(part.length).toBeLessThanOrEqual(12);
      for (let i = 0; i < part.length; i++) {
        const [a, b, c] = [part[i]!, part[(i + 1) % part.length]!, part[(i + 2) % part.length]!];
        expect((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)).toBeGreaterThan(0);
      }
    }
  });

  it('is as wide to the left as to the right, with its axle through the origin', () => {
    const ys = type.body.outlineMm.flat().map((corner) => corner.y);
    expect(Math.max(...ys)).toBe(-Math.min(...ys));
    const [left, right] = type.body.wheels;
    expect([left.atMm.x, right.atMm.x]).toEqual([0, 0]);
    expect(left.atMm.y).toBe(-right.atMm.y);
    expect(left.atMm.y).toBeGreaterThan(0);
  });

  it('has a centre of mass inside its outline and a mass of 50 g to 1 kg', () => {
    const xs = type.body.outlineMm.flat().map((corner) => corner.x);
    expect(type.body.centreOfMassMm.x).toBeGreaterThan(Math.min(...xs));
    expect(type.body.centreOfMassMm.x).toBeLessThan(Math.max(...xs));
    expect(type.body.massG).toBeGreaterThan(50);
    expect(type.body.massG).toBeLessThan(1000);
  });

  it('brings Python libraries the real robot can run: no f-strings, no tabs, only the device’s modules', () => {
    const known = ['microbit', 'machine', 'neopixel', 'music', 'utime', 'gc'];
    for (const [file, source] of Object.entries(type.libraries)) {
      expect(file).toMatch(/^[a-z]\w*\.py$/i);
      expect(source).not.toMatch(/\bf["']|\t/);
      const imported = [...source.matchAll(/^\s*(?:from|import) (\w+)/gm)].map((match) => match[1]);
      expect(known).toEqual(expect.arrayContaining(imported));
    }
  });

  it('brings examples with a German and an English title', () => {
    expect(type.examples.length).toBeGreaterThan(0);
    for (const { file, title, source } of type.examples) {
      expect(file).toMatch(/\.py$/);
      expect(file.length).toBeLessThanOrEqual(LONGEST_FILE_NAME);
      expect(title.de).not.toBe('');
      expect(title.en).not.toBe('');
      expect(title.de).not.toContain('ß'); // Swiss spelling
      expect(source).not.toContain('ß');
    }
  });

  it('has a drawing in millimetres whose moving and shining parts carry names', () => {
    expect(type.drawing).toContain('<svg xmlns="http://www.w3.org/2000/svg"');
    for (const id of ['body', 'wheel-left', 'wheel-right']) expect(type.drawing).toContain(`id="${id}"`);
    const [, x, y, width, height] = /viewBox="(\S+) (\S+) (\S+) (\S+)"/.exec(type.drawing)?.map(Number) ?? [];
    for (const corner of type.body.outlineMm.flat()) {
      expect(-corner.y).toBeGreaterThanOrEqual(x!);
      expect(-corner.y).toBeLessThanOrEqual(x! + width!);
      expect(-corner.x).toBeGreaterThanOrEqual(y!);
      expect(-corner.x).toBeLessThanOrEqual(y! + height!);
    }
  });
});
