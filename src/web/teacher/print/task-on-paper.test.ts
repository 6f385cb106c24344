import { afterEach, describe, expect, it } from 'vitest';

import { defaultScene, type Scene } from '#scene/scene';

import { showLanguage } from '../../kit/i18n';
import { taskOnPaper } from './task-on-paper';

const course: Scene = { ...defaultScene(), task: { seconds: 20, noTouch: true, stars: [9, 15] } };
const checks = [{ id: '1', text: 'Le programme a une boucle', leds: null, gives: '2 points, facultatif' }];
const text = { title: 'Le slalom', text: 'Avance.', hints: ['Essaie left().'], picture: '' };

afterEach(() => showLanguage('de'));

describe('the task of a course for paper', () => {
  it('says goals, rules and stars in the language of the page, the slower time first', async () => {
    showLanguage('fr');
    expect(await taskOnPaper(course, text, checks, false)).toEqual({
      ...{ title: 'Le slalom', text: 'Avance.', picture: null, goalsTitle: 'Voici le but' },
      goals: ['Tiens 20 s'],
      rules: ['ne rien toucher', 'sans l’aide de la main'],
      checksTitle: 'Vérifié aussi',
      checks: ['Le programme a une boucle (2 points, facultatif)'],
      stars: ['réussi', 'en moins de 15 s', 'en moins de 9 s'],
      hints: [],
    });
  });

  it('has the hints only on request', async () => {
    showLanguage('it');
    expect((await taskOnPaper(course, text, [], true)).hints).toEqual([
      { title: 'Suggerimento 1', text: 'Essaie left().' },
    ]);
  });

  it('has no stars where the task gives none', async () => {
    expect((await taskOnPaper({ ...course, task: { seconds: 20, noTouch: false } }, text, [], false)).stars).toEqual(
      [],
    );
  });
});
