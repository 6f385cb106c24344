// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, type EffectScope } from 'vue';

import { createGallery, galleryPage, type GalleryModel } from './gallery-model';

describe('the address of a gallery', () => {
  it.each([
    ['#robots', { kind: 'all' }],
    ['#robots/callibot', { kind: 'robot', robot: 'callibot' }],
    ['#courses', { kind: 'courses' }],
    ['#courses/slalom', { kind: 'course', course: 'slalom' }],
    ['#course=slalom', { kind: 'course', course: 'slalom' }],
    ['#course/slalom', { kind: 'course', course: 'slalom' }],
    ['#courses=slalom', { kind: 'course', course: 'slalom' }],
    ['#missions', { kind: 'missions', robot: null }],
    ['#missions/callibot', { kind: 'missions', robot: 'callibot' }],
    ['#my-robot', { kind: 'my-robot' }],
    ['#class', { kind: 'class' }],
    ['#task', { kind: 'task' }],
    ['#make-series', { kind: 'make-series' }],
    ['#s=1.abc', { kind: 'series', from: 's=1.abc' }],
    ['#series=a/b/series.json', { kind: 'series', from: 'series=a/b/series.json' }],
    ['#series/woche-3', { kind: 'series', from: 'series/woche-3' }],
  ])('%s is known', (hash, page) => expect(galleryPage(hash)).toEqual(page));

  it.each([
    '',
    '#',
    '#robot',
    '#class/1',
    '#robots/a/b',
    '#courses/a/b',
    '#p=abc',
    '#Robots',
    '#s=',
    '#series',
    '#series/',
    '#slalom',
  ])('“%s” is none', (hash) => expect(galleryPage(hash)).toBeNull());
});

describe('the galleries', () => {
  let scope: EffectScope;
  const gallery = (): GalleryModel => scope.run(createGallery)!;
  beforeEach(() => {
    scope = effectScope(true);
    history.replaceState(null, '', '/?lang=de');
  });
  afterEach(() => {
    scope.stop();
    vi.restoreAllMocks();
    history.replaceState(null, '', '/');
  });

  it('are closed on a usual visit', () => expect(gallery().page.value).toBeNull());

  it('are open at the page that the address asks for', () => {
    history.replaceState(null, '', '#robots/callibot');
    expect(gallery().page.value).toEqual({ kind: 'robot', robot: 'callibot' });
  });

  it('open with an address that can be handed on', () => {
    const it = gallery();
    it.open();
    expect([it.page.value, location.hash]).toEqual([{ kind: 'all' }, '#robots']);
    it.open('callibot');
    expect([it.page.value, location.hash]).toEqual([{ kind: 'robot', robot: 'callibot' }, '#robots/callibot']);
    it.openCourses();
    expect([it.page.value, location.hash]).toEqual([{ kind: 'courses' }, '#courses']);
    it.openCourses('slalom');
    expect([it.page.value, location.hash]).toEqual([{ kind: 'course', course: 'slalom' }, '#courses/slalom']);
  });

  it('follow the browser’s back button', () => {
    const it = gallery();
    it.open('callibot');
    history.replaceState(null, '', '#robots');
    dispatchEvent(new PopStateEvent('popstate'));
    expect(it.page.value).toEqual({ kind: 'all' });
  });

  it('closed, leave no page of theirs behind: as many steps back as pages were opened', () => {
    const steps: unknown[] = [];
    const it = gallery();
    it.open();
    it.open('callibot');
    it.replaceCourse('slalom'); // takes the place of a page
    vi.spyOn(history, 'go').mockImplementation((by) => void steps.push(by));
    it.close();
    expect(it.page.value).toBeNull();
    expect(steps).toEqual([-2]);
  });

  it('closed after an address was followed, leave the visit’s own address', () => {
    history.replaceState(null, '', '/?lang=de#robots');
    const it = gallery();
    it.close();
    expect(location.pathname + location.search + location.hash).toBe('/?lang=de');
  });

  it('closed after an address was followed and another page opened, do not come back to the first one', () => {
    history.replaceState(null, '', '/?lang=de#make-series');
    const it = gallery();
    it.openSeries('woche-3');
    expect(it.page.value).toEqual({ kind: 'series', from: 'series/woche-3' });
    vi.spyOn(history, 'go').mockImplementation(() => {
      history.replaceState(null, '', '/?lang=de#make-series');
      dispatchEvent(new PopStateEvent('popstate'));
    });
    it.close();
    expect([it.page.value, location.hash]).toEqual([null, '']);
  });

  it('that are closed already are not left again', () => {
    const go = vi.spyOn(history, 'go').mockImplementation(() => undefined);
    gallery().close();
    expect(go).not.toHaveBeenCalled();
  });

  it('no longer follow the address once the page is gone', () => {
    const it = gallery();
    scope.stop();
    history.replaceState(null, '', '#robots');
    dispatchEvent(new PopStateEvent('popstate'));
    expect(it.page.value).toBeNull();
  });
});
