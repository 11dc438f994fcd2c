// What the live page says, by language. A sentence is a key; every language has the same keys.
import { answers_de } from './answers_de.js';
import { answers_fr } from './answers_fr.js';
import { de } from './de.js';
import { en } from './en.js';
import { fr } from './fr.js';
import { lesson_de } from './lesson_de.js';
import { lesson_en } from './lesson_en.js';
import { lesson_fr } from './lesson_fr.js';

export const sentences = {
  en: { ...en, lesson_words: lesson_en },
  de: { ...de, lesson_words: lesson_de, answers: answers_de },
  fr: { ...fr, lesson_words: lesson_fr, answers: answers_fr }
};
