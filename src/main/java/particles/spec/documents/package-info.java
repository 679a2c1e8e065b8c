/**
 * Documents made from a declared format: the JSON Schema that editors use, and the reference tables.
 */
package particles.spec.documents;
