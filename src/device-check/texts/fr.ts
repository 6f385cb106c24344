import type { RuleTexts } from './texts';

/** French: *tu*. */
export const fr: RuleTexts = {
  'f-string': 'Le {board} ne connaît pas les f-strings. Écris plutôt {instead}',
  'text-method': 'Sur le {board}, les textes n’ont pas de {name}(). Écris plutôt {instead}',
  'bytes-hex': 'Sur le {board}, les octets n’ont pas de {name}(). Écris plutôt {instead}',
  'bytes-fromhex': '{name}() n’existe pas sur le {board}. Écris plutôt {instead}',
  'star-arguments':
    'Dans un appel, le {board} ne permet qu’un seul * et, après lui, plus d’arguments simples. Réunis d’abord les listes : f(*(a + b))',
  'dict-union': 'Le {board} ne sait pas réunir deux dictionnaires avec |. Écris plutôt {instead}',
  'pow-three': 'Sur le {board}, pow() ne prend que deux nombres. Écris plutôt {instead}',
  'round-whole':
    'Le {board} ne sait pas arrondir un nombre entier à un nombre de chiffres. Fais-en d’abord un nombre à virgule : {instead}',
  'next-default':
    'Sur le {board}, next() ne prend pas de valeur de remplacement. Attrape la fin avec try: … except StopIteration:.',
  'not-implemented': 'NotImplemented n’existe pas sur le {board}. Arrête avec raise TypeError().',
  'builtin-name': '{name}() n’existe pas sur le {board}. exec() exécute directement un texte.',
  'int-bytes': 'Sur le {board}, {name}() veut connaître l’ordre des octets. Écris {instead}',
  'special-method':
    'Le {board} n’appelle pas {name} : là-bas, ce signe de calcul ne marche pas avec tes propres classes. Écris une méthode comme {instead}() et appelle-la toi-même.',
  'reverse-method':
    'Le {board} n’appelle pas {name}. Mets ton objet à gauche du signe de calcul ou appelle une méthode.',
  'attribute-hook': 'Le {board} n’appelle pas {name}. Change la valeur avec une méthode à toi.',
  descriptor: 'Le {board} n’appelle pas {name}. Prends plutôt @property.',
  'function-attribute': 'Sur le {board}, les fonctions n’ont pas de {name}. Écris toi-même le nom dans un texte.',
  'slice-attribute':
    'Sur le {board}, les morceaux comme [1:3] ne disent pas leur {name}. Écris une méthode avec deux arguments.',
  'array-slice':
    'Dans {name}, le {board} ne sait pas remplacer tout un morceau d’un coup. Remplace les octets dans une boucle.',
  'math-name': '{name} n’existe pas sur le {board}. Écris plutôt {instead}',
  'math-missing': '{name} n’existe pas sur le {board}. Écris une fonction à toi pour cela.',
  deque: 'deque n’existe pas sur le {board}. Prends une liste avec append() et pop(0).',
  'time-name':
    'Le {board} ne connaît pas {name}, car il n’a pas d’horloge. running_time() donne les millisecondes depuis le départ.',
  'type-name': 'Seuls les éditeurs connaissent {name}, le {board} non. Enlève-le.',
  module: 'Le module {name} n’existe pas sur le {board}. Enlève-le ou ajoute un fichier {name}.py.',
  'module-instead': 'Le module {name} n’existe pas sur le {board}. Ceci peut t’aider : {instead}',
  'newer-name':
    '{name} n’existe qu’avec un micrologiciel plus récent. Avec le micrologiciel choisi, le {board} s’arrête ici sur une erreur.',
  'float-digits': 'Le {board} calcule avec environ 7 chiffres. Les derniers de {name} se perdent.',
  'float-range': '{name} est trop grand pour le {board} : il le prend pour l’infini.',
};
