import { describe, expect, it } from 'vitest';

import { attachmentDrawings } from '#attachments/drawings';
import { attachmentTypes } from '#attachments/types';
import type { Texts } from '#core/languages';
import { fn, module, type, value, absent } from '#reference/table';
import { robotTypes } from '#robots/index';
import { robotReferences } from '#robots/references';
import { robotSheets } from '#robots/sheets';
import { featurePages } from '../../../app/features/feature-pages';
import { pageAt } from '../../../session/layout/router';
import { addressesText, addressText, sizeCm } from './facts';
import { libraryTables } from './library-rows';
import { robotPicture } from '../../device/robot-picture';
import deviceWords from '../../device/words';
import { REALITIES } from '../../device/realities';
import galleryWords from '../words/robots';

const slots = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

describe('the words of the gallery and the device panel', () => {
  const panel = Object.fromEntries(Object.entries(deviceWords).filter(([name]) => name !== 'realities'));
  const all: readonly Texts[] = [
    ...Object.values<Texts>(galleryWords),
    ...Object.values(panel as Readonly<Record<string, Texts>>),
    ...REALITIES.map(({ name }) => name),
  ];

  it('leave the same places open in German and English, and no German text has an ß', () => {
    for (const { de, en } of all) {
      expect(slots(en), en).toEqual(slots(de));
      expect(de).not.toContain('ß');
    }
  });
});

describe('every robot in the gallery', () => {
  it.each(robotTypes.map((robot) => [robot.name, robot] as const))(
    '%s has a sheet with words, an example and a size',
    (_, robot) => {
      const sheet = robotSheets.find((one) => one.robot === robot.id);
      expect(sheet?.about.de.length).toBeGreaterThan(20);
      expect(sheet?.examples.length).toBeGreaterThan(0);
      const { length, width } = sizeCm(robot);
      expect(length).toBeGreaterThan(5);
      expect(width).toBeLessThan(25);
    },
  );

  it('has each library in its table, and every name in it with words in both languages', () => {
    for (const reference of robotReferences)
      for (const language of ['de', 'en'] as const)
        for (const table of libraryTables(reference, language)) {
          expect(table.text, table.module).not.toBe('');
          for (const row of table.rows)
            expect(row.text, `${language}: ${table.module}.${row.codes.join()}`).not.toBe('');
        }
  });
});

describe('every attachment in the gallery', () => {
  it('has a picture, a title and a sentence on its angles', () => {
    expect(attachmentTypes.length).toBeGreaterThanOrEqual(4);
    for (const { id, title, about } of attachmentTypes) {
      expect(attachmentDrawings[id], id).toMatch(/<svg[^>]* viewBox=/);
      for (const text of [title, about]) expect(text.de + text.en, id).not.toContain('ß');
      expect(
        [about.de, about.en].every((text) => /\d°/.test(text)),
        id,
      ).toBe(true);
    }
  });
});

describe('the table of a library', () => {
  const reference = {
    robot: 'x',
    modules: [
      module('bot', {
        go: fn('(speed: int) -> None'),
        near: fn('() -> int'),
        motL: value('Motor'),
        Motor: type(['(side: int)'], { rotate: fn('(speed: int) -> None') }),
        never: absent(fn('() -> int')),
      }),
    ],
    texts: {
      bot: { de: 'Fährt.', fr: '', it: '', en: 'Drives.' },
      'bot.Motor.rotate': { de: '', fr: '', it: '', en: 'Turns.' },
    },
  };

  it('names things as a program writes them, members behind their dot, and not what the robot lacks', () => {
    const [table] = libraryTables(reference, 'en');
    expect([table!.module, table!.text]).toEqual(['bot', 'Drives.']);
    expect(table!.rows.flatMap(({ codes }) => codes)).toEqual([
      'go(speed: int)',
      'near() -> int',
      'motL: Motor',
      'Motor(side: int)',
      'Motor.rotate(speed: int)',
    ]);
    expect(table!.rows.at(-1)?.text).toBe('Turns.');
  });

  it('says once what several names one after the other do, such as the eleven of RobotContext', () => {
    for (const reference of robotReferences)
      for (const { module, rows } of libraryTables(reference, 'de')) {
        const repeated = rows.filter((row, i) => row.text === rows[i - 1]?.text);
        expect(repeated, module).toEqual([]);
      }
    const [lite] = robotReferences
      .filter(({ robot }) => robot === 'maqueen-lite')
      .flatMap((it) => libraryTables(it, 'de'));
    const told = lite?.rows.find(({ codes }) => codes.some((code) => code.includes('RobotContext.')));
    expect(told?.codes.length).toBeGreaterThanOrEqual(11);
  });
});

describe('the portrait of a robot', () => {
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-50 -60 100 90"><circle id="rgb-0" cx="-30" cy="-40" r="10"/><circle id="led-left" cx="-10" cy="-50" r="2"/></svg>';

  it('shows the drawing as it is, without the places of the lights under it', () => {
    const { href, box, body, lights } = robotPicture(svg, false);
    expect(decodeURIComponent(href)).toMatch(/^data:image\/svg\+xml,<svg [^>]*><style>\[id\^="rgb-"\]/);
    expect(box).toEqual(body);
    expect(lights).toEqual([]);
  });

  it('lights it on request: a glow under the body and a red light on it, with room around', () => {
    const { box, lights } = robotPicture(svg, true);
    expect(lights.map(({ below, x }) => [below, x])).toEqual([[true, -30], [false, -10]]); // prettier-ignore
    expect(box).toEqual({ x: -58, y: -68, width: 116, height: 106 });
  });
});

describe('addresses', () => {
  it('of the bus are written as in data sheets', () => {
    expect([0x10, 0x5, 0x2a].map(addressText)).toEqual(['0x10', '0x05', '0x2A']);
    expect(addressesText({ address: 0x22 })).toBe('0x22');
    expect(addressesText({ address: 0x23, lastAddress: 0x27 })).toBe('0x23 … 0x27');
  });

  it('of the gallery’s pages name the robot; others belong to somebody else', () => {
    expect(pageAt('#robots', featurePages)).toEqual({ name: 'robots', id: null });
    expect(pageAt('#robots/', featurePages)).toEqual({ name: 'robots', id: null });
    expect(pageAt('#robots/callibot', featurePages)).toEqual({ name: 'robots', id: 'callibot' });
    expect(pageAt('#courses', featurePages)).toEqual({ name: 'courses', id: null });
    expect(pageAt('#courses/slalom', featurePages)).toEqual({ name: 'courses', id: 'slalom' });
    for (const hash of ['#course=slalom', '#course/slalom', '#courses=slalom'])
      expect(pageAt(hash, featurePages), hash).toEqual({ name: 'courses', id: 'slalom' });
    for (const hash of ['', '#', '#course', '#robotsx', '#robots/a/b', '#courses/a/b'])
      expect(pageAt(hash, featurePages)).toBeNull();
  });
});
