import type { Ability, Platform } from './ways';

/** The browser's words about itself. */
export interface BrowserWords {
  readonly userAgent: string;
  readonly maxTouchPoints: number;
}

/** The kind of device that a browser runs on. An iPad says that it is a Mac, but no Mac has a screen to touch. */
export function platformOf({ userAgent, maxTouchPoints }: BrowserWords): Platform {
  if (/iPad|iPhone|iPod/.test(userAgent) || (/Macintosh/.test(userAgent) && maxTouchPoints > 1)) return 'ipad';
  if (/Android/.test(userAgent)) return 'android';
  return /\bCrOS\b/.test(userAgent) ? 'chromebook' : 'computer';
}

/** True if a browser on an iPad is Safari itself, from which the micro:bit app cannot be reached with a file. */
export const isSafari = ({ userAgent }: BrowserWords): boolean =>
  /Safari\//.test(userAgent) && !/Chrome|CriOS|FxiOS|EdgiOS|OPiOS/.test(userAgent);

/** Finds out whether the page can use an interface of the browser, by the name of the frame's permission for it. */
export function abilityOf(name: 'usb' | 'serial'): Ability {
  if ((navigator as { readonly usb?: unknown; readonly serial?: unknown })[name] === undefined) return 'browser';
  const { featurePolicy } = document as { readonly featurePolicy?: { allowsFeature?(name: string): boolean } };
  return featurePolicy?.allowsFeature?.(name) === false ? 'frame' : 'yes';
}
