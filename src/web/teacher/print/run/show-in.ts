import { t } from '../../../kit/i18n';
import words from './words';

/** Shows a picture of a run as the only thing in its place, named for screen readers. */
export function showIn(host: HTMLElement | null, picture: HTMLCanvasElement): void {
  picture.setAttribute('role', 'img');
  picture.setAttribute('aria-label', t(words.preview));
  host?.replaceChildren(picture);
}
