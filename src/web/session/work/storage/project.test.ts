import { describe, expect, it } from 'vitest';

import { defaultProjectSettings, type Project } from '#project/project';
import { serializeScene } from '#scene/serialize';
import { defaultScene } from '#scene/scene';

import { CROWDED_CHARACTERS, putAside, workToText, type Previous } from './history';
import { defaultSettings, settingsFromText } from '../settings/settings';
import { unpackProject, workFromText } from './read-work';
import { packedText } from './stored-project';

const project = (text: string): Project => ({
  files: [{ name: 'main.py', text }],
  scene: defaultScene(),
  course: null,
});

const packed = (of: Project): Record<string, unknown> => JSON.parse(packedText(of)) as Record<string, unknown>;

describe('a stored project', () => {
  it('comes back as it was', () => {
    expect(unpackProject(packed(project('print(1)')))).toEqual(project('print(1)'));
  });

  it('keeps what it runs on, where it says so', () => {
    const chosen = {
      ...project(''),
      settings: { ...defaultProjectSettings, robotOptions: { callibot: { lamp: 'on' } } },
    };
    const stored = packed(chosen);
    expect(unpackProject(stored)).toEqual(chosen);
    expect(unpackProject({ ...stored, settings: { robot: 7 } })).toEqual(project(''));
  });

  it('keeps what makes it a task, and a hand-in', () => {
    const handed = { ...project(''), task: { version: 1, id: 'A' }, handIn: { version: 1, alias: 'Ada' } };
    const stored = packed(handed);
    expect(unpackProject(stored)).toEqual(handed);
    expect(unpackProject({ ...stored, task: 7, handIn: [] })).toEqual(project(''));
  });

  it('is refused when it has no main.py or makes no sense', () => {
    const stored = packed(project(''));
    for (const broken of [
      null,
      7,
      {},
      { ...stored, files: [] },
      { ...stored, files: [{ name: 'x.py', text: '' }] },
      { ...stored, scene: {} },
    ]) {
      expect(unpackProject(broken)).toBeNull();
    }
  });
});

describe('stored work', () => {
  const previous: Previous[] = [{ name: 'Linie', atMs: 5, project: project('old') }];

  it('comes back with the open file and the earlier work', () => {
    const work = { project: project('new'), open: 'main.py', previous };
    expect(workFromText(workToText(work))).toEqual(work);
  });

  it('comes back with the names of the files it was opened from', () => {
    const from = previous.map((entry) => ({ ...entry, file: 'Beat' }));
    const work = { project: project('new'), open: 'main.py', file: 'Anna "A"', previous: from };
    expect(workFromText(workToText(work))).toEqual(work);
  });

  it('remembers that it was handed in', () => {
    const work = { project: project('new'), open: 'main.py', isHandedIn: true as const, previous };
    expect(workFromText(workToText(work))).toEqual(work);
  });

  it('comes back with what was deleted, and which works a closed tab has left', () => {
    const ofTab = previous.map((entry) => ({ ...entry, isOfTab: true as const }));
    const work = {
      ...{ project: project('new'), open: 'main.py', previous: ofTab },
      deleted: [{ name: 'Linie', atMs: 5, deletedMs: 7, project: project('gone') }],
    };
    expect(workFromText(workToText(work))).toEqual(work);
  });

  it('is kept once for each file it was opened from', () => {
    const entry = { name: 'Linie', atMs: 5, project: project('same') };
    const kept = ['Anna', 'Beat', 'Anna'].reduce(
      (all: readonly Previous[], file) => putAside(all, { ...entry, file }),
      [],
    );
    expect(kept.map(({ file }) => file)).toEqual(['Anna', 'Beat']);
  });

  it('stored before works were deleted and came from tabs is read as it was', () => {
    const scene = serializeScene(defaultScene());
    const old = (text: string): string =>
      `{"files":[{"name":"main.py","text":"${text}"}],"scene":${scene},"course":null}`;
    const text = `{"savedMs":5,"version":1,"project":${old('new')},"open":"main.py","previous":[{"name":"Linie","atMs":3,"file":"Anna","project":${old('before')}}]}`;
    expect(workFromText(text)).toEqual({
      ...{ project: project('new'), open: 'main.py' },
      previous: [{ name: 'Linie', atMs: 3, file: 'Anna', project: project('before') }],
    });
  });

  it('never stops the app when it is broken', () => {
    for (const text of ['', '{', 'null', '{"version":2}', '[1]']) expect(workFromText(text)).toBeNull();
  });

  const kept = (texts: readonly string[]): readonly string[] =>
    texts
      .reduce((all: readonly Previous[], text, atMs) => putAside(all, { name: 'x', atMs, project: project(text) }), [])
      .map((entry) => entry.project.files[0]!.text);

  it('keeps all twelve programs of a lesson, newest first, none of them twice', () => {
    const names = Array.from({ length: 12 }, (_, place) => String(place));
    expect(kept([...names, '6'])).toEqual(['6', '11', '10', '9', '8', '7', '5', '4', '3', '2', '1', '0']);
  });

  it('gives up none of them, however large they are', () => {
    const long = (sign: string): string => sign.repeat(CROWDED_CHARACTERS / 4);
    const all = kept(['a', 'b', ...['c', 'd', 'e', 'f', 'g'].map(long)]);
    expect(all.map(([sign]) => sign)).toEqual(['g', 'f', 'e', 'd', 'c', 'b', 'a']);
  });
});

describe('stored settings', () => {
  // Whoever has stored settings has been here before: nobody greets them.
  const fallback = { ...defaultSettings('de'), welcomed: true };

  it('come back as they were', () => {
    const settings = { ...fallback, language: 'en', theme: 'dark', speed: 'max', codePx: 300, muted: true } as const;
    expect(settingsFromText(JSON.stringify(settings), fallback)).toEqual(settings);
  });

  it('fall back one by one where they make no sense', () => {
    const text = JSON.stringify({ language: 'xx', theme: 'dark', speed: 3, codePx: 'wide', cone: 1 });
    expect(settingsFromText(text, fallback)).toEqual({ ...fallback, theme: 'dark' });
    expect(settingsFromText('{', fallback)).toEqual(fallback);
    expect(settingsFromText(null, fallback)).toEqual(fallback);
  });
});
