import { describe, expect, it } from 'vitest';

import { PARTS } from '#embed/simulator';

import { hostWish } from './address';
import { noHost } from './host-view';

const wishOf = (address: string, page: Readonly<Record<string, string>> = {}) =>
  hostWish(new URL(address, 'https://parcours.example/'), page);
const settingsOf = (address: string) => wishOf(address).settings;

describe('the address of the page', () => {
  it('asks for nothing when nothing is in it; a page around it may speak as with WebTigerPython', () => {
    const nothing = { ...noHost, dialect: 'webtigerpython' };
    expect(wishOf('/')).toEqual(nothing);
    expect(wishOf('/#p=1.abc')).toEqual(nothing);
    expect(wishOf('/?unknown=1#section')).toEqual(nothing);
  });

  it('names the mode in which the arena begins; looking back is up to a link to a run', () => {
    expect(['build', 'drive', 'lookBack', ''].map((mode) => wishOf(`/?mode=${mode}`).mode)).toEqual(['build', 'drive', null, null]); // prettier-ignore
  });

  it('is read in the query and behind #?, also below a path of WebTigerPython; the first of two counts', () => {
    expect(settingsOf('/?lang=fr')).toEqual({ language: 'fr' });
    expect(settingsOf('/#?lang=fr')).toEqual({ language: 'fr' });
    expect(settingsOf('/Graphics/Turtle/gturtle#?code=abc&lang=it')).toEqual({ language: 'it' });
    expect(settingsOf('/?lang=de#?lang=fr')).toEqual({ language: 'de' });
    expect(settingsOf('/?lang=de&lang=fr')).toEqual({ language: 'de' });
  });

  it('chooses the language, also with its region', () => {
    expect(settingsOf('/?lang=de-CH')).toEqual({ language: 'de' });
    expect(settingsOf('/?lang=EN_us')).toEqual({ language: 'en' });
    expect(settingsOf('/?lang=zh')).toEqual({});
  });

  it('chooses light or dark, by our name or by that of WebTigerPython', () => {
    expect(settingsOf('/?theme=dark')).toEqual({ theme: 'dark' });
    expect(settingsOf('/?dark_mode=true')).toEqual({ theme: 'dark' });
    expect(settingsOf('/?dark_mode')).toEqual({ theme: 'dark' });
    expect(settingsOf('/?dark_mode=false')).toEqual({ theme: 'light' });
    expect(settingsOf('/?dark_mode=false&theme=system')).toEqual({ theme: 'system' });
    expect(settingsOf('/?dark_mode=constructor&theme=pink')).toEqual({});
  });

  it('chooses the microcomputer by the name of WebTigerPython or by our id', () => {
    const deviceOf = (name: string) => settingsOf(`/?device=${encodeURIComponent(name)}`).device;
    expect(deviceOf('micro:bit')).toBe('microbit-v2');
    expect(deviceOf('Calliope mini 1/2')).toBe('calliope-mini-2');
    expect(deviceOf('Calliope mini 3')).toBe('calliope-mini-3');
    expect(deviceOf('calliope-mini-3')).toBe('calliope-mini-3');
    expect(deviceOf('-')).toBe('auto');
    expect(deviceOf('Oxocard')).toBeUndefined();
    expect(deviceOf('__proto__')).toBeUndefined();
    expect(settingsOf('/?board=microbit-v2&device=Calliope%20mini%203')).toEqual({ device: 'microbit-v2' });
  });

  it('chooses robot, used robot, faults, speed and sound', () => {
    expect(settingsOf('/?robot=maqueen-lite&seed=7&reality=0.5&speed=max&muted=true')).toEqual({
      robot: 'maqueen-lite',
      seed: 7,
      reality: 0.5,
      speed: 'max',
      muted: true,
    });
    expect(settingsOf('/?robot=none&speed=0.25&reality=0&muted=0')).toEqual({ robot: 'none', speed: 0.25, reality: 0, muted: false }); // prettier-ignore
    expect(settingsOf('/?robot=cat&seed=0&seed=1e9&reality=-1&speed=3&muted=loud')).toEqual({});
    expect(settingsOf('/?seed=&reality=&speed=&robot=')).toEqual({});
    expect(settingsOf('/?seed=1.5&reality=NaN&speed=Infinity')).toEqual({});
  });

  it('never starts a program', () => {
    expect(settingsOf('/?run=true&run_code&autostart=1')).toEqual({});
  });
});

describe('the parts that an address shows', () => {
  const partsOf = (address: string, page?: Readonly<Record<string, string>>) => wishOf(address, page).settings.parts;

  it('are those of `show`, in whatever order they are named', () => {
    expect(partsOf('/?show=arena,board')).toEqual(['board', 'arena']);
    expect(partsOf('/?show=arena&show=board')).toEqual(['board', 'arena']);
    expect(partsOf('/?show=board+arena')).toEqual(['board', 'arena']);
    expect(partsOf('/?show=all')).toEqual(PARTS);
    expect(partsOf('/?show=garden')).toBeUndefined();
    expect(partsOf(`/?show=${'board,'.repeat(1000)}`)).toBeUndefined();
  });

  it('are the panes of a layout of WebTigerPython, nested or not', () => {
    const layout = (value: unknown) => partsOf(`/?layout=${encodeURIComponent(JSON.stringify(value))}`);
    expect(layout(['Editor', 'Canvas'])).toEqual(['bar', 'code', 'board', 'arena']);
    expect(layout([['Editor', 'Canvas'], 'Console'])).toEqual(['bar', 'code', 'board', 'arena', 'console']);
    expect(layout(['Canvas'])).toEqual(['bar', 'board', 'arena']);
    expect(layout('Editor')).toEqual(['bar', 'code']);
    expect(layout([])).toBeUndefined();
    expect(layout([7, null, { Editor: 1 }, '__proto__'])).toBeUndefined();
    expect(partsOf('/?layout=%5B%22Editor')).toBeUndefined();
    expect(partsOf(`/?layout=${'['.repeat(900)}${']'.repeat(90)}`)).toBeUndefined();
    expect(partsOf(`/?layout=${'['.repeat(100_000)}`)).toBeUndefined();
  });

  it('are without the bar where the address hides it', () => {
    const noBar = PARTS.filter((part) => part !== 'bar');
    expect(partsOf('/?hide_topbar=true')).toEqual(noBar);
    expect(partsOf('/?hide_topbar=false')).toBeUndefined();
    expect(partsOf('/?hide_topbar=1&layout=["Editor"]')).toEqual(['code']);
    expect(partsOf('/?full_screen=true')).toEqual(['board', 'arena']);
    expect(partsOf('/?full_screen=true&show=bar,console')).toEqual(['console']);
  });

  it('are those of the page where the address says nothing', () => {
    const page = { parts: 'board', dialect: 'microbit', keepsWork: 'false' };
    expect(wishOf('/', page)).toEqual({ ...noHost, settings: { parts: ['board'] }, dialect: 'microbit', keepsWork: false }); // prettier-ignore
    expect(partsOf('/?show=board,arena', page)).toEqual(['board', 'arena']);
  });
});

describe('who may command, by the address', () => {
  it('are the origins that it names; what is none lets nobody in', () => {
    expect(wishOf('/').origins).toEqual([]);
    expect(wishOf('/?origin=https://a.example/lesson&origin=http://b.example:8080').origins).toEqual([
      'https://a.example',
      'http://b.example:8080',
    ]);
    expect(wishOf('/?origin=nonsense&origin=about:blank').origins).toEqual(['nonsense', 'about:blank']);
    expect(wishOf(`/?${'origin=https://a.example&'.repeat(1000)}`).origins).toHaveLength(20);
  });

  it('speak the dialect that it names, else that of the page', () => {
    expect(wishOf('/?dialect=microbit').dialect).toBe('microbit');
    expect(wishOf('/?dialect=none').dialect).toBeNull();
    expect(wishOf('/?dialect=none', { dialect: 'microbit' }).dialect).toBeNull();
    expect(wishOf('/?dialect=klingon', { dialect: 'microbit' }).dialect).toBe('microbit');
    expect(wishOf('/?dialect=toString').dialect).toBe('webtigerpython');
  });

  it('may give the play button a colour, and flags', () => {
    expect(wishOf('/?color=%2300ff00').color).toBe('#00ff00');
    expect(wishOf('/?color=rgb(1, 2, 3)').color).toBe('rgb(1, 2, 3)');
    expect(wishOf('/?color=red;background:url(//evil)').color).toBeNull();
    expect(wishOf('/?flag=sound&flag=*').flags).toEqual(['sound', '*']);
  });
});
