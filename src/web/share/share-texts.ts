import type { Texts } from '#core/texts';

/** The words of the dialogs for sharing and opening, and of what happens there; they come late. */
export const shareTexts = {
  title: { de: 'Projekt teilen', en: 'Share the project' },
  about: {
    de: 'Wer den Link öffnet, hat dasselbe Projekt auf dem eigenen Gerät. Alles steht im Link selbst, nichts geht ins Netz.',
    en: 'Whoever opens the link has the same project on their own device. All of it is in the link itself; nothing is uploaded.',
  },
  link: { de: 'Link zum Projekt', en: 'Link to the project' },
  copy: { de: 'Kopieren', en: 'Copy' },
  copied: { de: 'Der Link ist kopiert.', en: 'The link has been copied.' },
  copyByHand: {
    de: 'Der Browser erlaubt das Kopieren nicht. Der Link ist markiert: Kopiere ihn mit Ctrl+C.',
    en: 'The browser does not allow copying. The link is selected: copy it with Ctrl+C.',
  },
  program: { de: 'Mit Programm', en: 'With the program' },
  programHint: {
    de: 'Ohne Programm teilst du nur die Strecke als Aufgabe. Sie öffnet sich mit leerem Programm.',
    en: 'Without the program you share the course only, as a task. It opens with an empty program.',
  },
  length: { de: '{count} Zeichen', en: '{count} characters' },
  long: {
    de: 'Der Link ist lang ({count} Zeichen). Manche Chats und Mailprogramme schneiden ihn ab: Speichere dann das Projekt als Datei.',
    en: 'The link is long ({count} characters). Some chats and mail programs cut it off: then save the project as a file.',
  },
  tooLong: {
    de: 'Dieses Projekt ist zu gross für einen Link. Speichere es als Datei und gib sie weiter.',
    en: 'This project is too large for a link. Save it as a file and pass that on.',
  },
  noPicture: {
    de: 'Das Hintergrundbild hat im Link keinen Platz: Der Boden kommt grob mit, so wie ihn die Sensoren lesen.',
    en: 'The background image has no room in the link: the floor comes along coarsely, as the sensors read it.',
  },
  noBackground: {
    de: 'Das Hintergrundbild hat im Link keinen Platz. Mit ihm gibst du das Projekt als Datei weiter.',
    en: 'The background image has no room in the link. To pass it on, save the project as a file.',
  },
  saveFile: { de: 'Als Datei speichern', en: 'Save as a file' },
  qr: { de: 'QR-Code des Links', en: 'QR code of the link' },
  qrTooLong: {
    de: 'Für einen QR-Code ist der Link zu lang: {count} Zeichen, höchstens {max}.',
    en: 'The link is too long for a QR code: {count} characters, {max} at most.',
  },
  large: { de: 'Gross zeigen', en: 'Show it large' },
  small: { de: 'Wieder klein', en: 'Make it small again' },
  close: { de: 'Schliessen', en: 'Close' },
  openTitle: { de: 'Link öffnen', en: 'Open a link' },
  openAbout: {
    de: 'Füge einen Link zu einem Projekt ein, oder einen von WebTigerPython. Deine Arbeit bleibt unter «Bisherige Arbeiten» aufbewahrt.',
    en: 'Paste a link to a project, or one of WebTigerPython. Your work is kept under “Earlier work”.',
  },
  openField: { de: 'Link', en: 'Link' },
  openNow: { de: 'Öffnen', en: 'Open' },
  shared: { de: 'Geteiltes Projekt', en: 'Shared project' },
  sharedProgram: { de: 'Geteiltes Programm', en: 'Shared program' },
  courseChanged: {
    de: '«{name}» ist geöffnet. Die Strecke ist seit dem Teilen verbessert worden.',
    en: '“{name}” is open. The course has been improved since it was shared.',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** Why a file or a link opens nothing. Places such as `objects[2]` are as in the file. */
export const problemTexts = {
  file: { de: '{file}: {reason}', en: '{file}: {reason}' },
  otherKind: {
    de: '{file} kann hier nicht geöffnet werden. Es gehen Programme (.py), Projekte und Strecken (.json).',
    en: '{file} cannot be opened here. What can: programs (.py), projects and courses (.json).',
  },
  tooLargeFile: {
    de: '{file} ist zu gross: {size} MB, erlaubt sind {max} MB.',
    en: '{file} is too large: {size} MB, the limit is {max} MB.',
  },
  unreadable: { de: '{file} lässt sich nicht lesen.', en: '{file} cannot be read.' },
  notALink: {
    de: 'Das ist kein Link zu einem Projekt.',
    en: 'This is no link to a project.',
  },
  damagedLink: {
    de: 'Der Link ist beschädigt: Ein Teil fehlt oder ist verändert. Kopiere ihn nochmals ganz.',
    en: 'The link is damaged: a part of it is missing or changed. Copy it again, whole.',
  },
  newerLink: {
    de: 'Der Link kommt aus einer neueren Version. Lade die Seite neu und öffne ihn nochmals.',
    en: 'The link is from a newer version. Reload the page and open it again.',
  },
  hugeLink: {
    de: 'Der Link enthält viel zu viel und wird nicht geöffnet.',
    en: 'The link holds far too much and is not opened.',
  },
  unknownCourse: {
    de: 'Die Strecke «{course}» gibt es hier nicht. Lade die Seite neu.',
    en: 'There is no course “{course}” here. Reload the page.',
  },
  invalidLink: {
    de: 'Im Link steht kein gültiges Projekt: {reason}',
    en: 'The link holds no valid project: {reason}',
  },
  offline: {
    de: 'Ein Teil der App lädt nicht. Prüfe die Verbindung und versuche es nochmals.',
    en: 'A part of the app does not load. Check the connection and try again.',
  },
  newerFile: {
    de: 'Die Datei kommt aus einer neueren Version. Lade die Seite neu und öffne sie nochmals.',
    en: 'The file is from a newer version. Reload the page and open it again.',
  },
  unknownVersion: { de: 'Version {version} ist unbekannt.', en: 'version {version} is unknown.' },
  notJson: {
    de: 'Das ist kein JSON: Zeile {line}, Spalte {column}.',
    en: 'this is not JSON: line {line}, column {column}.',
  },
  notOurs: {
    de: 'Das ist weder ein Projekt noch eine Strecke.',
    en: 'this is neither a project nor a course.',
  },
  notALevel: {
    de: 'Bei {path} steht etwas, was wir nicht kennen.',
    en: 'there is something at {path} that we do not know.',
  },
  tooLong: {
    de: '{path}: zu lang ({length} statt höchstens {max}).',
    en: '{path}: too long ({length}, the limit is {max}).',
  },
  tooMany: {
    de: '{path}: zu viele ({count} statt höchstens {max}).',
    en: '{path}: too many ({count}, the limit is {max}).',
  },
  missing: { de: '{path} fehlt.', en: '{path} is missing.' },
  wrongType: { de: '{path}: {value} ist hier nicht möglich.', en: '{path}: {value} is not possible here.' },
  outOfRange: {
    de: '{path}: {value} liegt nicht zwischen {min} und {max}.',
    en: '{path}: {value} is not between {min} and {max}.',
  },
  unknown: { de: '{path} ist unbekannt.', en: '{path} is unknown.' },
  duplicate: { de: '{path}: {value} kommt zweimal vor.', en: '{path}: {value} is there twice.' },
  noLength: { de: '{path}: Die Wand hat keine Länge.', en: '{path}: the wall has no length.' },
  damagedPart: { de: '{path} ist beschädigt.', en: '{path} is damaged.' },
  noMain: { de: 'Die erste Datei muss main.py heissen.', en: 'the first file must be main.py.' },
  fileName: { de: '{value} ist kein möglicher Dateiname.', en: '{value} cannot be the name of a file.' },
  more: { de: '{reason} (und {count} mehr)', en: '{reason} (and {count} more)' },
} as const satisfies Readonly<Record<string, Texts>>;
