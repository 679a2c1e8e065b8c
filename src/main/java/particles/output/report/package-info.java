/**
 * Results of experiments as pages: Markdown with pictures and tables, one HTML report, and JUnit's XML for graders.
 */
package particles.output.report;
