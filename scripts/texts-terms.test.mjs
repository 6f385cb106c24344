import { describe, expect, it } from 'vitest';
import { refusedIn, terms } from './texts-terms.mjs';

const PUPIL = 'src/web/pupil/code/words/ hint';
const TEACHER = 'src/web/teacher/class/words/ hint';

describe('the list of terms', () => {
  it('has a word for each thing in every language, and refuses none of them', () => {
    for (const { thing, say, not } of terms) {
      expect(Object.keys(say), thing).toEqual(['de', 'fr', 'it', 'en']);
      for (const [language, refused] of Object.entries(not))
        expect(say[language], `${thing} in ${language}`).not.toMatch(refused);
    }
  });

  it('finds whole words only, small or large', () => {
    expect(refusedIn(PUPIL, 'de', 'Klotz schieben')[0]).toMatch(/^“Klotz” is called “Block” in de/);
    expect(refusedIn(PUPIL, 'fr', 'Micrologiciel')[0]).toMatch(/^“Micrologiciel” is called “firmware”/);
    expect(refusedIn(PUPIL, 'fr', 'un pique-nique')).toEqual([]);
  });

  it('lets a word stand where it means something else', () => {
    expect(refusedIn(PUPIL, 'it', 'La scheda si accende.')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'it', 'Stampa la scheda di lavoro')).toEqual([]);
    expect(refusedIn('src/reference/words/ microbit.compass', 'fr', 'Le champ magnétique')).toEqual([]);
  });

  it('does not look into code, addresses and places for values', () => {
    expect(
      refusedIn(PUPIL, 'de', '`display.show()` auf dem {board}: display.rotate, siehe https://board.example'),
    ).toEqual([]);
    expect(refusedIn(PUPIL, 'de', 'Bild: {web/board:title}')).toEqual([]);
  });
});

describe('the rules of spelling', () => {
  it('have one quotation mark for each language', () => {
    expect(refusedIn(PUPIL, 'de', 'Drücke „Stopp“')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'fr', 'Appuie sur «Arrêter»')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'fr', 'Appuie sur «\u202fArrêter\u202f»')).toEqual([]);
    expect(refusedIn(PUPIL, 'en', 'Press «Stop»')).toHaveLength(1);
  });

  it('know one form of each German imperative', () => {
    expect(refusedIn(PUPIL, 'de', 'Drück den Knopf')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'de', 'Drücke den Knopf, zieh die Linie')).toEqual([]);
    expect(refusedIn(PUPIL, 'de', 'Fahre durch das Tor')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'de', 'Ein Tipp zur Aufgabe, ein Versuch')).toEqual([]);
  });

  it('want ’ in words and … for three dots', () => {
    expect(refusedIn(PUPIL, 'en', "the robot's way")).toHaveLength(1);
    expect(refusedIn(PUPIL, 'en', 'Open...')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'fr', 'Image …')).toHaveLength(1);
  });
});

describe('the second person in French', () => {
  it('is «vous» on the pages of teachers and «tu» on those of pupils', () => {
    expect(refusedIn(TEACHER, 'fr', 'Choisis la tâche.')).toHaveLength(1);
    expect(refusedIn(TEACHER, 'fr', 'Choisissez votre tâche.')).toEqual([]);
    expect(refusedIn(PUPIL, 'fr', 'Ouvrez votre programme.')).toHaveLength(1);
    expect(refusedIn(PUPIL, 'fr', 'Ouvre ton programme.')).toEqual([]);
  });
});
