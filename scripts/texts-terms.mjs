/**
 * One word for one thing in each language: how the page calls it, and what it is not called. `npm run check` reports a text
 * that says a refused word, with the right one. A translator adds a row when a thing gets a name.
 *
 * @typedef {{
 *   thing: string,
 *   say: Readonly<Record<string, string>>,
 *   not: Readonly<Record<string, RegExp>>,
 *   but?: RegExp,
 * }} Term a thing; `not`: words refused for it, by language; `but`: places (room and name of the text) where these words
 *   mean something else and are right
 */

/** Whole words, whatever stands before and after them; `~` is any ending. */
const words = (...them) =>
  new RegExp(`(?<![\\p{L}\\d])(?:${them.join('|').replaceAll('~', '\\p{L}*')})(?![\\p{L}\\d])`, 'iu');
/** The same, with capitals as they are written. */
const exactly = (...them) => new RegExp(words(...them).source, 'u');

/** @type {readonly Term[]} */
export const terms = [
  {
    thing: 'the micro:bit or Calliope mini',
    say: { de: 'Mikrocomputer', fr: 'microcontrôleur', it: 'microcomputer', en: 'microcomputer' },
    not: {
      de: words('Boards?', 'Platinen?', 'Mikrocontroller~'),
      fr: words('(?:la|de|une|votre|ta|toute) carte', 'cartes? micro~', 'micro-ordinateurs?'),
      it: words(
        '(?:la|della|sulla|alla|una|sola) scheda(?! di lavoro| sulla protezione| da stampare| propria| del browser)',
      ),
      en: exactly('boards?', 'Boards?'),
    },
    but: /(real-device|teacher)\/.* it|class\/wall|courses\/room|debug\/words\/help.* it|(handbook|web\/teacher|session\/task)\/.* fr|handbook\/sheet\/.* it/,
  },
  {
    thing: 'a run of the program',
    say: { de: 'Lauf', fr: 'essai', it: 'prova', en: 'run' },
    not: { fr: words('exécutions?'), it: words('corsa', 'corse', '(?<!in )esecuzion[ei]') },
    but: /RuntimeError/,
  },
  {
    thing: 'the target, a zone of the course',
    say: { de: 'Ziel', fr: 'arrivée', it: 'traguardo', en: 'target' },
    not: { it: words('arriv[oi](?= |\\.|,|:|$)(?<!che )', 'met[ae]', 'obiettiv[oi]'), fr: words('dans un but') },
    but: /missions\/09/,
  },
  {
    thing: 'a zone on the floor',
    say: { de: 'Feld', fr: 'zone', it: 'zona', en: 'zone' },
    not: {
      de: words('(?<!dead_)Zonen?'),
      fr: words('champs?(?! magnétique)'),
      it: words('camp[oi](?! magnetic~| di misura)'),
      en: words('(?<!magnetic )fields?'),
    },
    but: /reference|robots\/|sizeMissing|sizeUnread|sizeLimited|compass/,
  },
  {
    thing: 'spikes of a block',
    say: { de: 'Stacheln', fr: 'pointes', it: 'punte', en: 'spikes' },
    not: { fr: words('pics?') },
  },
  {
    thing: 'a block',
    say: { de: 'Block', fr: 'bloc', it: 'blocco', en: 'block' },
    not: { de: words('Kl[oö]tz~') },
  },
  {
    thing: 'a thing in the course',
    say: { de: 'Ding', fr: 'objet', it: 'oggetto', en: 'object' },
    not: {
      fr: words('(?:une|des|les|1|\\{0\\}) choses?'),
      it: words('(?:una|le|1|\\{0\\}) cos[ae](?! più)'),
      en: words('(?:a|the|of|all|take|select|1|\\{0\\}) things?'),
    },
    but: /advice|happened\.several|missions|ask-why|stages\.desk|notes\.(keys|parameters)/,
  },
  {
    thing: 'a hint of a task',
    say: { de: 'Tipp', fr: 'indice', it: 'suggerimento', en: 'hint' },
    not: {
      fr: words('conseils?'),
      it: words('consigli~', 'gli aiuti', '(?:un|l’)aiuto (?:\\d|\\{)', '(?:scrivi|aggiungi|guarda) (?:un |l’)aiuto'),
    },
  },
  {
    thing: 'what a class gets to do',
    say: { de: 'Aufgabe', fr: 'tâche', it: 'compito', en: 'task' },
    not: { fr: words('exercices?', 'consignes?'), it: words('esercizi~') },
  },
  {
    thing: 'what pupils give to the teacher',
    say: { de: 'Abgabe', fr: 'travail rendu', it: 'consegna', en: 'hand-in' },
    not: { fr: words('remises?', '(?:le|un|du|ce|chaque) rendu', '(?:les|des|ces) rendus'), en: words('submissions?') },
  },
  {
    thing: 'how much a robot is like a used one',
    say: { de: 'Abnutzung', fr: 'usure', it: 'usura', en: 'wear' },
    not: {
      de: words('Zustand des Roboters'),
      fr: words('état du robot'),
      it: words('(?:condizioni|stato) del robot'),
      en: words('condition of the robot'),
    },
  },
  {
    thing: 'a world that the class does not see',
    say: { de: 'verborgene Welt', fr: 'monde caché', it: 'mondo nascosto', en: 'hidden world' },
    not: { de: words('versteckte[nr]? Welt~'), en: words('secret worlds?') },
  },
  {
    thing: 'what a task keeps as it is on the page of the class',
    say: { de: 'Sperren', fr: 'verrous', it: 'restrizioni', en: 'locks' },
    not: { it: words('(?:i|senza) blocchi(?: del compito)?(?= del compito|$)') },
  },
  {
    thing: 'what the check wants a teacher to look at; the teacher’s own words',
    say: { de: 'Bemerkung; Notiz', fr: 'remarque; annotation', it: 'osservazione; nota', en: 'remark; note' },
    not: { de: words('Anmerkung~') },
  },
  {
    thing: 'the results of a class on the projector',
    say: { de: 'Ergebniswand', fr: 'tableau d’affichage', it: 'bacheca', en: 'results wall' },
    not: { fr: words('murs? (?:des résultats|pour le projecteur)', 'tableau des résultats'), it: words('parete') },
  },
  {
    thing: 'the list of a pupil’s own work',
    say: { de: 'Meine Arbeiten', fr: 'Mes travaux', it: 'I miei lavori', en: 'My work' },
    not: {
      de: words('Bisherige Arbeiten', 'letzten Projekten?'),
      fr: words('Travaux précédents', 'derniers projets'),
      it: words('Lavori precedenti', 'ultimi progetti'),
      en: exactly('Earlier work', 'latest projects'),
    },
    but: /guide\/words|texts\.course/,
  },
  {
    thing: 'the cross that keys move over the arena',
    say: { de: 'Fadenkreuz', fr: 'viseur', it: 'mirino', en: 'crosshair' },
    not: { de: words('Kreuz'), fr: words('croix'), it: words('croce') },
    but: /Image/,
  },
  {
    thing: 'the 5 × 5 lights',
    say: { de: 'Anzeige', fr: 'écran', it: 'display', en: 'display' },
    not: { de: words('Display~') },
  },
  {
    thing: 'lights of any colour',
    say: { de: 'Farblicht', fr: 'LED de couleur', it: 'LED colorato', en: 'colour light' },
    not: { fr: words('(?:lampe|lumière)s? de couleur'), it: words('luc[ei] colorat[ae]') },
    but: /robots\/|courses\//,
  },
  {
    thing: 'the program that makes a device run MicroPython',
    say: { de: 'Firmware', fr: 'firmware', it: 'firmware', en: 'firmware' },
    not: { fr: words('micrologiciels?') },
  },
  {
    thing: 'the teacher',
    say: { de: 'Lehrperson', fr: 'enseignant', it: 'insegnante', en: 'teacher' },
    not: {
      de: words('Lehrer~', 'Lehrkr~'),
      fr: words('enseignant·e~', 'prof~'),
      it: words('docent[ei]', 'professor~'),
    },
    but: /builtins|reference/,
  },
  {
    thing: 'the way of looking at a run again',
    say: { de: 'Rückblick', fr: 'Revoir', it: 'Rivedi', en: 'Look back' },
    not: { fr: words('retour en arrière'), it: words('«?Rivedere»?(?= il|»|$)') },
  },
  {
    thing: 'the way that a robot drove',
    say: { de: 'Weg', fr: 'trajet', it: 'tragitto', en: 'path' },
    not: { it: words('strad[ae]', '(?:suo|tuo) percorso può') },
  },
  {
    thing: 'keys of the keyboard',
    say: {
      de: 'Umschalttaste, Eingabetaste, Esc',
      fr: 'Maj, Entrée, Échap',
      it: 'Maiusc, Invio, Esc',
      en: 'Shift, Enter, Esc',
    },
    not: {
      de: words('Shift', 'Escape(?:-Taste)?', 'Enter', 'mit Umschalt'),
      fr: words('Shift', 'Escape', 'Esc', 'Enter'),
      it: words('Shift', 'Escape', 'Enter'),
      en: exactly('Escape'),
    },
  },
  {
    thing: 'sizes of files',
    say: { de: 'kB, MB, GB', fr: 'ko, Mo, Go', it: 'kB, MB, GB', en: 'kB, MB, GB' },
    not: { fr: exactly('[kMG]B') },
  },
];

/**
 * The second person: pupils are addressed with *tu* everywhere, teachers with *vous* in French. German and Italian say *du*
 * and *tu* to both; only the handbook says *Sie* to teachers.
 */
const FOR_TEACHERS =
  /^src\/web\/teacher\/(class|classes|desk|my-tasks|projector|shelf|task-maker|tournament)\/|^src\/web\/teacher\/series\/.* make\.|^src\/web\/help\/handbook\/(words|texts|sheet)\//;
const FOR_BOTH = /^src\/(check|cli|school-class)\/|\/handbook\/texts\/.* class\b/;
const TU =
  /(?<![\p{L}’'-])(?:tu|te|toi|ton|ta|tes|t’\p{L}+)(?![\p{L}-])|(?<=^|[.:;!?] |,\s)(?:Choisis|Écris|Prends|Mets|Fais|Essaie|Glisse|Recharge)(?![\p{L}])/u;
const VOUS = words('vous', 'votre', 'vos');
const LEI = words('trascini', 'scelga', 'incolli(?!n)', 'apra', 'prema', 'salvi', 'aggiunga', 'faccia clic');

/** German imperatives end in -e where both forms were in use; short are: fahr, schreib, zieh, komm, lass, geh, halt. */
const WITHOUT_E =
  /(?<![\p{L}«-])(?:Drück|Füg|Prüf|Wähl|Versuch|Setz|Stell|Leg|Rück|Kürz|Lösch|Zähl|Lad|Übertrag|Kopier|drück|füg|prüf|wähl|setz|stell|leg|rück|kürz|lösch|zähl|lad|kopier)(?= (?!.*heisst))(?= \p{L}| «)/u;
const WITH_E =
  /(?<![\p{L}])(?:[Ff]ahre|[Ss]chreibe|[Zz]iehe|[Kk]omme|[Ll]asse|[Gg]ehe|[Ss]chiebe)(?= (?:sie|ihn|es|den|die|das|durch|dann|der|zu|in|ins|auf|dein|einen|eine|ein|bis|zuerst)\b)/u;

/** Rules of spelling that need no list of words: language → what is wrong, and how it is found. */
const spelling = {
  de: [
    ['quotation marks are «…» in German', /[„“”]/],
    ['what turns without going anywhere turns “auf der Stelle”', /\ban Ort\b(?! und)/],
    ['this imperative ends in -e', WITHOUT_E],
    ['this imperative has no -e', WITH_E],
  ],
  fr: [
    ['no space before the dots of a button or of a wait', /^[^…]*[\p{L}}]{4}[ \u202f\u00a0]…$/u],
    ['«\u202f…\u202f» has narrow spaces', /«(?!\u202f)|(?<!\u202f)»/],
    ['quotation marks are «\u202f…\u202f» in French', /[„“”]/],
  ],
  it: [['quotation marks are «…» in Italian', /[„“”]/]],
  en: [
    ['“is no …” is “is not a …”', /(?:\b(?:this|that)|\{\w+\}) is no (?!longer|more)/i],
    ['quotation marks are “…” in English', /[«»„]/],
  ],
};

/** A text without what is code in it: `backticks`, calls with brackets, strings in straight quotation marks, places for values and words. */
const withoutCode = (text) =>
  text
    .replace(
      /`[^`]*`|\{[\w/-]+:[\w.-]+\}|\b[\w.]+\([^)]*\)|"[^"]*"|\bb'[^']*'|\(\.\.\.\)|https?:\S+|\b\w+\.\w+\b|#\w+=/g,
      '0',
    )
    .replace(/\{\w+\}/g, '{0}');

/**
 * The faults of a text, by the list of terms and the rules of spelling.
 *
 * @param {string} where room and name of the text
 * @param {string} language
 * @param {string} text
 * @returns {string[]}
 */
export function refusedIn(where, language, text) {
  const said = withoutCode(text);
  const wrong = [];
  for (const { say, not, but } of terms) {
    const found = not[language]?.exec(said)?.[0];
    if (found !== undefined && !but?.test(`${where} ${language}`))
      wrong.push(`“${found}” is called “${say[language]}” in ${language}`);
  }
  for (const [rule, pattern] of spelling[language] ?? []) {
    const found = pattern.exec(said)?.[0];
    if (found !== undefined) wrong.push(`${rule}: “${found}”`);
  }
  if (/\p{L}'\p{L}/u.test(said)) wrong.push('an apostrophe is ’');
  if (/ {2}|\.\.\./.test(said)) wrong.push('two spaces, or three dots for …');
  if (language === 'it' && !where.includes('/handbook/texts/') && LEI.test(said))
    wrong.push(`the page says «tu» to everybody, not “${LEI.exec(said)?.[0]}”`);
  if (language === 'fr' && FOR_TEACHERS.test(where) && !FOR_BOTH.test(where) && TU.test(said))
    wrong.push(`teachers are addressed with “vous”, not “${TU.exec(said)?.[0]}”`);
  if (language === 'fr' && !FOR_TEACHERS.test(where) && !FOR_BOTH.test(where) && VOUS.test(said))
    wrong.push(`pupils are addressed with “tu”, not “${VOUS.exec(said)?.[0]}”`);
  return wrong.map((problem) => `${problem}: ${text}`);
}
