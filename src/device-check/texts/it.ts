import type { RuleTexts } from './texts';

/** Italian: *tu*. */
export const it: RuleTexts = {
  'f-string': 'Il {board} non conosce le f-string. Scrivi invece {instead}',
  'text-method': 'Sul {board} i testi non hanno {name}(). Scrivi invece {instead}',
  'bytes-hex': 'Sul {board} i byte non hanno {name}(). Scrivi invece {instead}',
  'bytes-fromhex': '{name}() non esiste sul {board}. Scrivi invece {instead}',
  'star-arguments':
    'In una chiamata il {board} permette un solo * e dopo di lui nessun argomento semplice. Unisci prima le liste: f(*(a + b))',
  'dict-union': 'Il {board} non sa unire due dizionari con |. Scrivi invece {instead}',
  'pow-three': 'Sul {board} pow() prende solo due numeri. Scrivi invece {instead}',
  'round-whole':
    'Il {board} non sa arrotondare un numero intero a un numero di cifre. Prima fanne un numero con la virgola: {instead}',
  'next-default':
    'Sul {board} next() non prende un valore di riserva. Cattura la fine con try: … except StopIteration:.',
  'not-implemented': 'NotImplemented non esiste sul {board}. Interrompi con raise TypeError().',
  'builtin-name': '{name}() non esiste sul {board}. exec() esegue direttamente un testo.',
  'int-bytes': 'Sul {board} {name}() vuole sapere l’ordine dei byte. Scrivi {instead}',
  'special-method':
    'Il {board} non chiama {name}: lì questo segno di calcolo non funziona con le tue classi. Scrivi un metodo come {instead}() e chiamalo tu.',
  'reverse-method':
    'Il {board} non chiama {name}. Metti il tuo oggetto a sinistra del segno di calcolo o chiama un metodo.',
  'attribute-hook': 'Il {board} non chiama {name}. Cambia il valore con un metodo tuo.',
  descriptor: 'Il {board} non chiama {name}. Usa invece @property.',
  'function-attribute': 'Sul {board} le funzioni non hanno {name}. Scrivi tu il nome come testo.',
  'slice-attribute': 'Sul {board} i ritagli come [1:3] non dicono il loro {name}. Scrivi un metodo con due argomenti.',
  'array-slice':
    'In {name} il {board} non sa sostituire un intero ritaglio in una volta. Sostituisci i byte in un ciclo.',
  'math-name': '{name} non esiste sul {board}. Scrivi invece {instead}',
  'math-missing': '{name} non esiste sul {board}. Scrivi per questo una funzione tua.',
  deque: 'deque non esiste sul {board}. Usa una lista con append() e pop(0).',
  'time-name': 'Il {board} non conosce {name}, perché non ha un orologio. running_time() dà i millisecondi dall’avvio.',
  'type-name': 'Solo gli editor conoscono {name}, il {board} no. Toglilo.',
  module: 'Il modulo {name} non esiste sul {board}. Toglilo o aggiungi un file {name}.py.',
  'module-instead': 'Il modulo {name} non esiste sul {board}. Forse ti aiuta {instead}',
  'newer-name':
    '{name} esiste solo con un firmware più recente. Con il firmware scelto il {board} qui si ferma con un errore.',
  'float-digits': 'Il {board} calcola con circa 7 cifre. Le ultime di {name} vanno perse.',
  'float-range': '{name} è troppo grande per il {board}: per lui è come l’infinito.',
};
