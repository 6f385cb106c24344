// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, type EffectScope } from 'vue';

import { featurePages } from '../../app/features/feature-pages';
import { Back } from '../../kit/overlays/back';
import { createRouter, pageAt, type Router } from './router';

describe('the address of a page over the app', () => {
  it.each([
    ['#robots', { name: 'robots', id: null }],
    ['#robots/callibot', { name: 'robots', id: 'callibot' }],
    ['#courses', { name: 'courses', id: null }],
    ['#courses/slalom', { name: 'courses', id: 'slalom' }],
    ['#course=slalom', { name: 'courses', id: 'slalom' }],
    ['#course/slalom', { name: 'courses', id: 'slalom' }],
    ['#courses=slalom', { name: 'courses', id: 'slalom' }],
    ['#missions', { name: 'missions', id: null }],
    ['#missions/callibot', { name: 'missions', id: 'callibot' }],
    ['#my-robot', { name: 'my-robot', id: null }],
    ['#class', { name: 'class', id: null }],
    ['#task', { name: 'task', id: null }],
    ['#make-series', { name: 'make-series', id: null }],
    ['#s=1.abc', { name: 'series', id: 's=1.abc' }],
    ['#series=a/b/series.json', { name: 'series', id: 'series=a/b/series.json' }],
    ['#series/woche-3', { name: 'series', id: 'series/woche-3' }],
  ])('%s is known', (hash, page) => expect(pageAt(hash, featurePages)).toEqual(page));

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
  ])('“%s” is none', (hash) => expect(pageAt(hash, featurePages)).toBeNull());
});

describe('the pages over the app', () => {
  let scope: EffectScope;
  const router = (): Router => scope.run(() => createRouter(featurePages, new Back()))!;
  beforeEach(() => {
    scope = effectScope(true);
    history.replaceState(null, '', '/?lang=de');
  });
  afterEach(() => {
    scope.stop();
    vi.restoreAllMocks();
    history.replaceState(null, '', '/');
  });

  it('are closed on a usual visit', () => expect(router().page.value).toBeNull());

  it('know the id of the open page only: a page that is being left sees none of the next', () => {
    const it = router();
    const ids = () => [it.idOn('robots'), it.idOn('courses')];
    it.open('robots', 'callibot');
    expect(ids()).toEqual(['callibot', null]);
    it.open('courses', 'slalom');
    expect(ids()).toEqual([null, 'slalom']);
  });

  it('are open at the page that the address asks for', () => {
    history.replaceState(null, '', '#robots/callibot');
    expect(router().page.value).toEqual({ name: 'robots', id: 'callibot' });
  });

  it('open with an address that can be handed on', () => {
    const it = router();
    it.open('robots');
    expect([it.page.value, location.hash]).toEqual([{ name: 'robots', id: null }, '#robots']);
    it.open('robots', 'callibot');
    expect([it.page.value, location.hash]).toEqual([{ name: 'robots', id: 'callibot' }, '#robots/callibot']);
    it.open('courses');
    expect([it.page.value, location.hash]).toEqual([{ name: 'courses', id: null }, '#courses']);
    it.open('courses', 'slalom');
    expect([it.page.value, location.hash]).toEqual([{ name: 'courses', id: 'slalom' }, '#courses/slalom']);
  });

  it('follow the browser’s back button', () => {
    const it = router();
    it.open('robots', 'callibot');
    history.replaceState(null, '', '#robots');
    dispatchEvent(new PopStateEvent('popstate'));
    expect(it.page.value).toEqual({ name: 'robots', id: null });
  });

  it('closed, leave no page of theirs behind: as many steps back as pages were opened', () => {
    const steps: unknown[] = [];
    const it = router();
    it.open('robots');
    it.open('robots', 'callibot');
    it.replace('courses', 'slalom'); // takes the place of a page
    vi.spyOn(history, 'go').mockImplementation((by) => void steps.push(by));
    it.close();
    expect(it.page.value).toBeNull();
    expect(steps).toEqual([-2]);
  });

  it('closed after an address was followed, leave the visit’s own address', () => {
    history.replaceState(null, '', '/?lang=de#robots');
    const it = router();
    it.close();
    expect(location.pathname + location.search + location.hash).toBe('/?lang=de');
  });

  it('closed after an address was followed and another page opened, do not come back to the first one', () => {
    history.replaceState(null, '', '/?lang=de#make-series');
    const it = router();
    it.open('series', 'woche-3');
    expect(it.page.value).toEqual({ name: 'series', id: 'series/woche-3' });
    vi.spyOn(history, 'go').mockImplementation(() => {
      history.replaceState(null, '', '/?lang=de#make-series');
      dispatchEvent(new PopStateEvent('popstate'));
    });
    it.close();
    expect([it.page.value, location.hash]).toEqual([null, '']);
  });

  it('leave no trace in the history of a host', () => {
    const framed = scope.run(() => createRouter(featurePages, new Back(() => true)))!;
    const [address, length] = [location.href, history.length];
    framed.open('courses', 'slalom');
    expect(framed.page.value).toEqual({ name: 'courses', id: 'slalom' });
    framed.replace('courses', 'meadow');
    expect(framed.idOn('courses')).toBe('meadow');
    framed.close();
    expect([framed.page.value, location.href, history.length]).toEqual([null, address, length]);
    history.replaceState(null, '', '#robots'); // a link in the frame
    dispatchEvent(new PopStateEvent('popstate'));
    expect(framed.page.value).toEqual({ name: 'robots', id: null });
    framed.close();
    expect([framed.page.value, location.href, history.length]).toEqual([null, address, length]);
  });

  it('are not left again if they are closed already', () => {
    const go = vi.spyOn(history, 'go').mockImplementation(() => undefined);
    router().close();
    expect(go).not.toHaveBeenCalled();
  });

  it('are those that features bring: another one needs no other place', () => {
    history.replaceState(null, '', '#trophies/gold');
    const trophies = { name: 'trophies', hasIds: true, load: () => Promise.reject(new Error()) } as const;
    const it = scope.run(() => createRouter([trophies], new Back()))!;
    expect(it.page.value).toEqual({ name: 'trophies', id: 'gold' });
    it.open('robots');
    expect(it.page.value).toBeNull();
  });

  it('no longer follow the address once the page is gone', () => {
    const it = router();
    scope.stop();
    history.replaceState(null, '', '#robots');
    dispatchEvent(new PopStateEvent('popstate'));
    expect(it.page.value).toBeNull();
  });
});
