import type { RuleTexts } from './texts';

/** German: *du*, Swiss spelling. */
export const de: RuleTexts = {
  'f-string': 'Der {board} kennt keine f-Strings. Schreib stattdessen {instead}',
  'text-method': 'Texte haben auf dem {board} kein {name}(). Schreib stattdessen {instead}',
  'bytes-hex': 'Das {name}() von Bytes fehlt auf dem {board}. Schreib stattdessen {instead}',
  'bytes-fromhex': '{name}() fehlt auf dem {board}. Schreib stattdessen {instead}',
  'star-arguments':
    'Der {board} erlaubt in einem Aufruf nur einen * und danach keine einfachen Angaben mehr. Füge die Listen vorher zusammen: f(*(a + b))',
  'dict-union': 'Der {board} kann zwei Wörterbücher nicht mit | verbinden. Schreib stattdessen {instead}',
  'pow-three': 'pow() nimmt auf dem {board} nur zwei Zahlen. Schreib stattdessen {instead}',
  'round-whole':
    'Eine ganze Zahl kann der {board} nicht auf Stellen runden. Mach zuerst eine Kommazahl daraus: {instead}',
  'next-default': 'next() nimmt auf dem {board} keinen Ersatzwert. Fang das Ende mit try: … except StopIteration: ab.',
  'not-implemented': 'NotImplemented gibt es auf dem {board} nicht. Brich mit raise TypeError() ab.',
  'builtin-name': '{name}() gibt es auf dem {board} nicht. exec() führt einen Text direkt aus.',
  'int-bytes': 'Der {board} will bei {name}() die Reihenfolge der Bytes wissen. Schreib {instead}',
  'special-method':
    'Der {board} ruft {name} nicht auf: Dieses Rechenzeichen geht dort mit eigenen Klassen nicht. Schreib eine Methode wie {instead}() und ruf sie selbst auf.',
  'reverse-method':
    'Der {board} ruft {name} nicht auf. Schreib dein Objekt links vom Rechenzeichen oder ruf eine Methode auf.',
  'attribute-hook': 'Der {board} ruft {name} nicht auf. Ändere den Wert mit einer eigenen Methode.',
  descriptor: 'Der {board} ruft {name} nicht auf. Nimm stattdessen @property.',
  'function-attribute': 'Funktionen haben auf dem {board} kein {name}. Schreib den Namen selbst als Text.',
  'slice-attribute':
    'Bereiche wie [1:3] verraten auf dem {board} ihr {name} nicht. Schreib eine Methode mit zwei Angaben.',
  'array-slice': 'Der {board} kann in {name} keinen Bereich auf einmal ersetzen. Ersetze die Bytes in einer Schleife.',
  'math-name': '{name} gibt es auf dem {board} nicht. Schreib stattdessen {instead}',
  'math-missing': '{name} gibt es auf dem {board} nicht. Schreib dafür eine eigene Funktion.',
  deque: 'deque gibt es auf dem {board} nicht. Nimm eine Liste mit append() und pop(0).',
  'time-name':
    'Der {board} kennt {name} nicht, denn er hat keine Uhr. running_time() gibt die Millisekunden seit dem Start.',
  'type-name': '{name} kennen nur Editoren, nicht der {board}. Lass es weg.',
  module: 'Das Modul {name} gibt es auf dem {board} nicht. Lass es weg oder lade eine Datei {name}.py dazu.',
  'module-instead': 'Das Modul {name} gibt es auf dem {board} nicht. Vielleicht hilft dir {instead}',
  'newer-name':
    '{name} gibt es erst mit neuerer Firmware. Der {board} mit der gewählten Firmware bricht hier mit einem Fehler ab.',
  'float-digits': 'Der {board} rechnet mit etwa 7 Stellen. Von {name} gehen die hinteren verloren.',
  'float-range': '{name} ist für den {board} zu gross: Er rechnet damit wie mit unendlich.',
};
