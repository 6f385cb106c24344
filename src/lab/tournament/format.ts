/** The name of the format of a tournament in a file. */
export const TOURNAMENT_FORMAT = 'parcours-tournament';

/** True if a text seems to be the file of a tournament: only then it is worth parsing. */
export const looksLikeTournament = (text: string): boolean =>
  /^\ufeff?\s*\{[^{[]*"format"\s*:\s*"parcours-tournament"/.test(text);
