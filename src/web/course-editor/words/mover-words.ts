import { wordsOf } from '#core/words';
import type de from './movers/de.json';

/** The texts about movers: what they do, their stops, and where they are. */
export const moverWords = wordsOf(import.meta.glob<typeof de>('./movers/*.json', { eager: true, import: 'default' }));
