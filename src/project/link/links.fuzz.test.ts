import LZString from 'lz-string';
import { describe, expect, it } from 'vitest';

import { packed, unpacked } from '#core/deflate';
import { createRng, type Rng } from '#core/rng';
import { parseScene } from '#scene/parse';
import { serializeScene } from '#scene/serialize';
import { mutatedText, mutatedTree } from '#scene/testing/mutate';

import { fromBase64Url } from '#core/base64-url';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { ColumnWriter, type Bytes } from './columns';
import { linkOf, linkOfBytes, projectOfLink } from './link';
import { deflatedBytes } from './link-bytes';
import { deflatedContent } from './link-content';
import type { Project } from '../project';
import { mutatedBytes } from '../testing/mutate';
import {
  classProject,
  coloursProject,
  fullProject,
  heightsProject,
  largeProject,
  shapesProject,
  startsProject,
} from '../testing/projects';
import { programOfLink, type ProgramLink } from '../webtigerpython/program-link';
import { noteText } from '../webtigerpython/say';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

const courses = (): null => null;
const linkFor = (project: Project): string => linkOf(project, { courses, program: true })?.fragment ?? '';

/** A few metres of a drawing among forty objects. */
function drawingProject(): Project {
  const scene = largeProject().scene;
  const objects = scene.objects.map((it) => (it.type === 'stroke' ? { ...it, points: it.points.slice(0, 99) } : it));
  return { ...fullProject(), scene: { ...scene, objects } };
}

/** A project as version 1 writes it, before it is deflated. */
function columnsOf({ files, course, settings, scene }: Project): Bytes {
  const out = new ColumnWriter();
  const content = { files, course, settings: settings ?? null, scene: { whole: scene }, extras: {}, myRobot: '', devices: null, starts: [], sharing: null, additions: [], firstRobot: null, carried: '', heights: [], news: '' }; // prettier-ignore
  deflatedContent.codec.write(out, content);
  return out.bytes();
}

/** A link of version 1 with a correct checksum and damaged content. */
function forgedColumns({ figures, words }: Bytes, rng: Rng): string {
  const parts =
    rng.unit() < 0.7 ? { figures: mutatedBytes(figures, rng), words } : { figures, words: mutatedBytes(words, rng) };
  return linkOfBytes({ version: 1, bytes: deflatedBytes(parts) });
}

/** The same for versions 2, 6, 7, 9, 10 and 11: from the changed place on, the model misinterprets every bit. */
function forgedModel(link: string, rng: Rng): string {
  const [version = '', data = ''] = link.slice(2).split('.');
  const bytes = fromBase64Url(data) ?? new Uint8Array();
  return linkOfBytes({
    version: ([2, 6, 7, 9, 10, 11] as const).find((known) => String(known) === version) ?? 2,
    bytes: mutatedBytes(bytes.subarray(4), rng),
  });
}

describe('randomly changed links', () => {
  it(
    `open as a valid project or give a message, never an exception (${String(fuzzRuns)} links)`,
    () => {
      const projects = [
        fullProject(),
        drawingProject(),
        startsProject(),
        shapesProject(),
        classProject(),
        heightsProject(),
        coloursProject(),
      ];
      const links = projects.map(linkFor);
      const columns = projects.slice(0, 2).map(columnsOf);
      const codes = new Map<string, number>();
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const index = seed % projects.length;
        const way = rng.unit();
        const link =
          way < 0.4
            ? forgedColumns(columns[seed % 2]!, rng)
            : way < 0.7
              ? forgedModel(links[index]!, rng)
              : mutatedText(links[index]!, rng);
        const read = projectOfLink(link, courses);
        const code = 'problem' in read ? read.problem.code : 'opened';
        codes.set(code, (codes.get(code) ?? 0) + 1);
        if ('problem' in read) expect(read.problem.message).not.toBe('');
      // An opened project can be shared again: nothing in it exceeds the limits of a link or a file.
      else expect(projectOfLink(linkFor(read.project), courses), `seed ${String(seed)}`).toMatchObject({ project: read.project }); // prettier-ignore
      }
      for (const code of ['opened', 'damaged', 'invalid'])
        expect(codes.get(code), code).toBeGreaterThan(fuzzRuns / 200);
    },
    TIME_LIMIT_MS,
  );

  it(
    `never unpack to more than the limit, whatever the deflated bytes are (${String(fuzzRuns)} of them)`,
    () => {
      const deflated = packed(new Uint8Array(100_000));
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const bytes = unpacked(mutatedBytes(deflated, createRng(seed)), 5_000);
        if (typeof bytes !== 'string') expect(bytes.length).toBeLessThanOrEqual(5_000);
      }
    },
    TIME_LIMIT_MS,
  );
});

describe('randomly changed links of WebTigerPython', () => {
  const lz = (value: unknown): string => LZString.compressToBase64(JSON.stringify(value));
  const files = [{ name: 'main.py', data: 'print("hallo")\n'.repeat(9) }, { name: 'fahren.py', data: 'ü = 1' }]; // prettier-ignore
  const world = {
    StartBox: [787.5, 1188.8, 0],
    Blockobjects: [[1643.9, 1139.3, false, 0], [300, 200, true, 3]],
    Wallobjects: [[660, 976, 557, 6], [528, 718, 225, 4], [433, 1035, 570, 2]],
    playgroundSize: [2000, 2000],
  }; // prettier-ignore

  it(
    `open as valid files or give a message, never an exception (${String(fuzzRuns)} links)`,
    () => {
      const link = `?code=${lz(files)}&device=micro:bit&playground=${encodeURIComponent(lz(world))}`;
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const read = programOfLink(mutatedText(link, createRng(seed)));
        if ('problem' in read) expect(read.problem.message).not.toBe('');
        else expectValid(read);
      }
    },
    TIME_LIMIT_MS,
  );

  it(
    `open with whatever their world says, and what is left out is told (${String(fuzzRuns)} worlds)`,
    () => {
      const codes = new Set<string>();
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const value = mutatedTree(world, createRng(seed), false);
        const read = programOfLink(`?code=${lz(files)}&playground=${encodeURIComponent(LZString.compressToBase64(JSON.stringify(value) ?? ''))}`); // prettier-ignore
        if ('problem' in read) throw new Error(`seed ${String(seed)}: ${read.problem.message}`);
        expectValid(read);
        for (const { code } of [...read.notes, ...(read.world?.notes ?? [])]) codes.add(code);
        expect(read.world === null, `seed ${String(seed)}`).toBe(read.notes.length > 0);
      }
      for (const code of ['worldUnknown', 'keys', 'startAngle', 'wallsUnread', 'blocksMovable', 'sizeUnread', 'far'])
        expect(codes, code).toContain(code);
    },
    TIME_LIMIT_MS,
  );

  function expectValid({ files: read, world: found, notes }: ProgramLink): void {
    expect(read[0]?.name ?? (found === null ? '' : 'main.py')).toBe('main.py');
    for (const one of [...notes, ...(found?.notes ?? [])]) expect(noteText(one, 'en')).not.toMatch(/^$|[{}]\w+[{}]/);
    if (found !== null) expect(parseScene(serializeScene(found.scene))).toEqual({ scene: found.scene });
  }
});
