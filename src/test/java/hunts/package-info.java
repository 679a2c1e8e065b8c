/** Programs that look for mistakes by themselves, by tasks of their own; what they find becomes tests. */
package hunts;
