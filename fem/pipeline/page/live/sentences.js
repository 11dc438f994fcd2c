// What the live page says, by language. A sentence is a key; every language has the same keys.
import { de } from './de.js';
import { en } from './en.js';
import { fr } from './fr.js';

export const sentences = { en, de, fr };
