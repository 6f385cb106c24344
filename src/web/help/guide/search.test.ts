import { describe, expect, it } from 'vitest';

import { fitOf, folded, wordsOf } from './search';

const fits = (query: string, name: string, text = ''): boolean => fitOf(wordsOf(query), name, text) > 0;

describe('searching the help', () => {
  it('does not care about capitals and accents, in the query and in the help', () => {
    expect(fits('demarrer', 'Démarrer')).toBe(true);
    expect(fits('DÉMARRER', 'demarrer')).toBe(true);
    expect(fits('velocita', 'Velocità')).toBe(true);
    expect(fits('zuruck', 'Zurück auf Start')).toBe(true);
    expect(folded('Größe’s')).toBe("grosse's");
  });

  it('wants every word, in any order, in the name or in the text', () => {
    expect(fits('start zurück', 'Zurück auf Start')).toBe(true);
    expect(fits('start roboter', 'Zurück auf Start', 'Der Roboter steht wieder am Anfang.')).toBe(true);
    expect(fits('start fisch', 'Zurück auf Start', 'Der Roboter steht wieder am Anfang.')).toBe(false);
  });

  it('finds parts of words: commands are found by any piece of their name', () => {
    expect(fits('distance', 'getDistance')).toBe(true);
    expect(fits('led', 'setLED')).toBe(true);
  });

  it('puts what begins so before what only mentions it', () => {
    const words = wordsOf('stop');
    expect(fitOf(words, 'Stopp', '')).toBeGreaterThan(fitOf(words, 'Ein Stopp', ''));
    expect(fitOf(words, 'Ein Stopp', '')).toBeGreaterThan(fitOf(words, 'Nonstop', ''));
    expect(fitOf(words, 'Nonstop', '')).toBeGreaterThan(fitOf(words, 'Ende', 'mit Stopp'));
  });

  it('finds other forms of a word, after the word itself', () => {
    expect(fits('drehen', 'left', 'Dreht sich nach links.')).toBe(true);
    expect(fits('tourner', 'left', 'Il tourne à gauche.')).toBe(true);
    expect(fits('girare', 'left', 'Gira a sinistra.')).toBe(true);
    expect(fits('turning', 'left', 'It turns left.')).toBe(true);
    expect(fits('led', 'left', 'Turns left.')).toBe(false);
    expect(fitOf(wordsOf('drehen'), 'drehen', '')).toBeGreaterThan(fitOf(wordsOf('drehen'), 'Dreht', ''));
  });

  it('takes everything for an empty query', () => {
    expect(wordsOf('  ')).toEqual([]);
    expect(fits('', 'Stopp')).toBe(true);
  });
});
