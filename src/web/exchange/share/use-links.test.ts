// @vitest-environment happy-dom
import LZString from 'lz-string';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h } from 'vue';

import { linkOf } from '#project/link/link';
import { defaultProjectSettings, type Project } from '#project/project';
import { defaultScene, type Scene } from '#scene/scene';

import { mountOn } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { t } from '../../kit/i18n';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import { courses } from '#catalogue/courses';
import { openAddress } from './open-address';
import { useLinks } from './use-links';

const own: Scene = { ...defaultScene(), name: 'Mein Kurs', size: [600, 400] };
const project = (more: Partial<Project> = {}): Project => ({
  ...{ files: [{ name: 'main.py', text: 'theirs = 2\n' }], scene: own, course: null },
  ...more,
});
/** The address behind `#` of a shared project. */
const linkTo = (shared: Project): string => `#${linkOf(shared, { courses: readyScene, program: true })?.fragment}`;
/** The program that is open. */
const program = (page: TestPage): string => page.work.work.value.project.files[0]?.text ?? '';
const said = (page: TestPage): string => {
  const { current } = page.notices;
  return current.value === null ? '' : t(current.value.key, current.value.values);
};
const slalom = courses.find(({ id }) => id === 'slalom')!;

beforeEach(() => history.replaceState(null, '', '/'));
afterEach(() => history.replaceState(null, '', '/'));

describe('an address', () => {
  const opened = (address: string, page = createPage()) => {
    page.settings.change({ language: 'de' });
    return { page, problem: openAddress(page, address) };
  };

  it('opens its project, whatever stands before it', () => {
    for (const before of ['', 'https://other.example/app/', '  parcours.example/?x=1']) {
      const { page, problem } = opened(before + linkTo(project()));
      expect(problem).toBeNull();
      expect(page.work.work.value.project).toMatchObject(project());
    }
  });

  it('calls a project without a name a shared one', () => {
    const { page } = opened(linkTo(project({ scene: { ...own, name: '' } })));
    expect(said(page)).toBe('«Geteiltes Projekt» ist geöffnet.');
  });

  it('only names a ready course, and opens it as it is here', () => {
    const address = linkTo(project({ scene: slalom.scene, course: 'slalom' }));
    expect(address.length).toBeLessThan(120);
    const { page } = opened(address);
    expect(page.work.work.value.project).toMatchObject({ course: 'slalom', scene: slalom.scene });
  });

  it('says when the course has been improved since', () => {
    const older = { ...slalom.scene, size: [slalom.scene.size[0], slalom.scene.size[1] + 10] as const };
    const made = linkOf(project({ scene: older, course: 'slalom' }), { courses: () => older, program: true });
    const { page, problem } = opened(`#${made?.fragment}`);
    expect(problem).toBeNull();
    expect(said(page)).toMatch(/^«Slalom» ist geöffnet\. Der Parcours ist seit dem Teilen verbessert worden\.$/);
    expect(page.work.scene.value.size).toEqual(slalom.scene.size);
  });

  it('brings the device of its project', () => {
    const { page } = opened(linkTo(project({ settings: { ...defaultProjectSettings, device: 'calliope-mini-3' } })));
    expect(page.settings.current.value.device).toBe('calliope-mini-3');
  });

  it('puts work of the pupil’s own aside, once', () => {
    const page = createPage();
    page.work.setText('main.py', 'mine = 1\n');
    const address = linkTo(project({ settings: defaultProjectSettings }));
    opened(address, page);
    opened(address, page);
    expect(page.work.work.value.previous.map((entry) => entry.project.files[0]?.text)).toEqual(['mine = 1\n']);
  });

  it('opens a course and its program with `task`, its arena alone with `world`', () => {
    const page = createPage();
    page.work.setText('main.py', 'mine = 1\n');
    opened('?world=slalom', page);
    expect([program(page), page.work.work.value.project.course]).toEqual(['mine = 1\n', 'slalom']);
    opened('https://parcours.example/?task=slalom', page);
    expect(program(page)).not.toBe('mine = 1\n');
    expect(page.work.work.value.previous).not.toHaveLength(0);
  });

  it('never starts a program', () => {
    const { page } = opened(linkTo(project()));
    expect(page.run.isActive.value).toBe(false);
    expect(page.sent.filter(({ type }) => type === 'run')).toEqual([]);
  });

  it('changes nothing if it holds something else', () => {
    for (const address of ['', 'hallo', 'https://example.org/', '#courses/slalom', '?task=nowhere', '?code=###']) {
      const page = createPage();
      const before = page.work.work.value;
      expect(opened(address, page).problem).not.toBeNull();
      expect(page.work.work.value).toBe(before);
    }
  });
});

describe('the address with which the page is called', () => {
  /** A page that was called like this. */
  function called(address: string, page = createPage()): TestPage {
    history.replaceState(null, '', address);
    const Links = defineComponent({ setup: () => (useLinks(page), () => h('p')) });
    page.settings.change({ language: 'de' });
    mountOn(page, Links);
    return page;
  }
  const address = (): string => location.pathname + location.search + location.hash;

  it('opens its project, and is that of the app again: a reload brings the work as it has become', async () => {
    const page = called(`/app/${linkTo(project())}`);
    await vi.waitFor(() => expect(program(page)).toBe('theirs = 2\n'));
    expect(address()).toBe('/app/');
    expect(page.work.isBrought).toBe(true);
    expect(page.run.isActive.value).toBe(false);
  });

  it('opens its course and keeps its other wishes', async () => {
    const page = called('/app/?task=slalom&speed=2&show=board,arena');
    await vi.waitFor(() => expect(page.work.work.value.project.course).toBe('slalom'));
    expect(address()).toMatch(/^\/app\/\?speed=2&show=board(,|%2C)arena$/);
    expect(page.settings.current.value.speed).toBe(2);
    expect(page.settings.own.value.speed).toBe(1);
    expect(page.host.parts.value).toEqual(['board', 'arena']);
  });

  it('opens no task over a program of WebTigerPython of which there is something to tell', async () => {
    const text = 'repeat:\n    pass\n';
    const code = encodeURIComponent(LZString.compressToBase64(JSON.stringify([{ name: 'main.py', data: text }])));
    const page = called(`/?code=${code}`);
    await vi.waitFor(() => expect(program(page)).toBe('while True:\n    pass\n'));
    await vi.waitFor(() => expect(location.search).toBe(''));
    expect(page.task.isNew.value).toBe(false);
    expect(page.work.arrivals.value).toBe(0);
  });

  it('shows a stranger’s program before it can run, although the link hides it', async () => {
    const page = called(`/app/?show=board,arena${linkTo(project())}`);
    await vi.waitFor(() => expect(program(page)).toBe('theirs = 2\n'));
    await vi.waitFor(() => expect(page.host.parts.value).toContain('code'));
    expect(decodeURIComponent(address())).toBe('/app/?show=board,arena,code');
  });

  it('is stronger than the device in the project: a host’s wish holds for the visit', async () => {
    const shared = project({ settings: { ...defaultProjectSettings, device: 'calliope-mini-3' } });
    const page = called(`/app/?device=microbit-v2${linkTo(shared)}`);
    await vi.waitFor(() => expect(program(page)).toBe('theirs = 2\n'));
    await vi.waitFor(() => expect(page.settings.current.value.device).toBe('microbit-v2'));
  });

  it('says what is wrong with it, and keeps the work', async () => {
    const page = called('/app/#p=2.AAAA');
    const before = program(page);
    await vi.waitFor(() => expect(said(page)).toMatch(/^Der Link ist beschädigt/));
    expect(page.notices.current.value?.kind).toBe('error');
    expect(program(page)).toBe(before);
    expect(page.work.isBrought).toBe(false);
    expect(address()).toBe('/app/');
  });

  it('is left as it is without work in it', async () => {
    const page = called('/app/?speed=4#courses');
    await vi.waitFor(() => expect(page.settings.current.value.speed).toBe(4));
    expect(address()).toBe('/app/?speed=4#courses');
  });

  it('is followed when another link is pasted into it', async () => {
    const page = called('/app/');
    history.replaceState(null, '', `/app/${linkTo(project())}`);
    dispatchEvent(new Event('hashchange'));
    await vi.waitFor(() => expect(program(page)).toBe('theirs = 2\n'));
    expect(address()).toBe('/app/');
  });
});
